// A button that acts only when held down: pointer, Space or Enter. Letting go cancels.

import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import "./hold_button.css";

interface HoldProps {
  /** What it does, for a screen reader, after the words that are seen; the holding is added. */
  name: string;
  holdMs?: number;
  /** Why it can't be held now, "" when it can: it can be focused, and does nothing. */
  why?: string;
  class?: string;
  title?: string;
  onHeld: () => void;
  children: ComponentChildren;
}

export function HoldButton({
  name,
  holdMs = 1000,
  why = "",
  class: look,
  title,
  onHeld,
  children,
}: HoldProps) {
  const holding = useSignal(false);
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const action = useRef(onHeld);
  action.current = onHeld;

  const release = (): void => {
    clearTimeout(timer.current);
    timer.current = undefined;
    holding.value = false;
  };
  const press = (): void => {
    if (why || timer.current !== undefined) return;
    holding.value = true;
    timer.current = setTimeout(() => {
      release();
      action.current();
    }, holdMs);
  };
  useEffect(() => release, []);
  useEffect(() => {
    if (why) release();
  }, [why !== ""]);

  const isHoldKey = (event: KeyboardEvent): boolean => event.key === " " || event.key === "Enter";
  return (
    <button
      type="button"
      class={`hold ${look ?? ""}`}
      data-holding={holding.value ? "yes" : undefined}
      aria-disabled={why !== ""}
      title={why || title}
      style={{ "--hold": `${holdMs}ms` }}
      onPointerDown={(event) => event.button === 0 && press()}
      onPointerUp={release}
      onPointerLeave={release}
      onPointerCancel={release}
      onBlur={release}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if (!isHoldKey(event)) return;
        event.preventDefault();
        if (!event.repeat) press();
      }}
      onKeyUp={(event) => isHoldKey(event) && release()}
    >
      <span class="hold-fill" aria-hidden="true" />
      <span class="hold-label">{children}</span>
      <span class="sr">
        . {name}: press and hold for {(holdMs / 1000).toFixed(1)} s
      </span>
    </button>
  );
}
