// A button that can be out of use and then says why. It keeps the keyboard's place meanwhile: a disabled one
// would drop the focus, and what then takes it could be the wrong one for the key that is still pressed.
import type { ComponentChildren } from "preact";

interface Props {
  /** Why it can't be pressed now, "" when it can: it is seen, can be focused, and does nothing. */
  why: string;
  type?: "button" | "submit";
  class: string;
  /** What it does. */
  title?: string;
  /** Its name where it shows none. */
  label?: string;
  onAct?: () => void;
  children: ComponentChildren;
}

export function ActButton({ why, type = "button", class: look, title, label, onAct, children }: Props) {
  return (
    <button
      type={type}
      class={look}
      title={why || title}
      aria-label={label}
      aria-disabled={why !== ""}
      onClick={(event) => (why ? event.preventDefault() : onAct?.())}
    >
      {children}
    </button>
  );
}
