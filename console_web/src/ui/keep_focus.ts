// Controls that come and go with the vehicle's state must not drop the keyboard's place to the page's top.
import type { RefObject } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

const CONTROLS = "button:not(:disabled), select:not(:disabled), input:not(:disabled)";

function lost(): boolean {
  const focused = document.activeElement;
  return focused === null || focused === document.body || focused.matches(":disabled");
}

/**
 * When the focused control of `box` went or was disabled, the first that can be used takes the focus; when the
 * whole box went, the view does. What is marked as `data-aside` was not what was being done. Looks at the page itself, not at renders: the control may go with any
 * component inside, in any order.
 */
export function useKeptFocus(box: RefObject<HTMLElement | null>): void {
  const within = useRef(false);
  useLayoutEffect(() => {
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
  const watched = useRef<{ box: HTMLElement; by: MutationObserver } | undefined>(undefined);
  useLayoutEffect(() => {
    const keep = (): void => {
      if (!within.current || !lost()) return;
      const all = box.current?.querySelectorAll<HTMLElement>(CONTROLS) ?? [];
      const next = [...all].find((control) => !control.closest("[data-aside]"));
      if (next) next.focus();
      else if (!box.current) document.querySelector<HTMLElement>("main:not([hidden])")?.focus();
    };
    keep();
    if (watched.current?.box === (box.current ?? undefined)) return;
    watched.current?.by.disconnect();
    watched.current = box.current ? { box: box.current, by: watch(box.current, keep) } : undefined;
  });
  useLayoutEffect(() => () => watched.current?.by.disconnect(), []);
}

function watch(box: HTMLElement, seen: () => void): MutationObserver {
  const observer = new MutationObserver(seen);
  observer.observe(box, {
    childList: true,
    subtree: true,
    attributes: true,
    attributeFilter: ["disabled"],
  });
  return observer;
}
