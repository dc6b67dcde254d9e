// Controls that come and go with the vehicle's state must not drop the keyboard's place to the page's top.
import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

const CONTROLS = "button:not(:disabled), select:not(:disabled), input:not(:disabled)";

/** When the focused control of `box` went or was disabled, the first that can be used takes the focus. */
export function useKeptFocus(box: RefObject<HTMLElement | null>): void {
  const within = useRef(false);
  useEffect(() => {
    const follow = (event: Event): void => {
      within.current = box.current?.contains(event.target as Node) ?? false;
    };
    document.addEventListener("focusin", follow);
    document.addEventListener("pointerdown", follow);
    return () => {
      document.removeEventListener("focusin", follow);
      document.removeEventListener("pointerdown", follow);
    };
  }, []);
  useLayoutEffect(() => {
    const focused = document.activeElement;
    const lost = focused === null || focused === document.body || focused.matches(":disabled");
    if (within.current && lost) box.current?.querySelector<HTMLElement>(CONTROLS)?.focus();
  });
}
