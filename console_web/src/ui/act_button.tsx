// A button that can be out of use for a while and keeps the keyboard's place meanwhile: a disabled one would
// drop the focus, and what then takes it could be the wrong one for the key that is still pressed.
import type { ComponentChildren } from "preact";

interface Props {
  /** Not now: it is seen and can be focused, and does nothing. */
  waiting: boolean;
  type?: "button" | "submit";
  class: string;
  title?: string;
  onAct?: () => void;
  children: ComponentChildren;
}

export function ActButton({ waiting, type = "button", class: look, title, onAct, children }: Props) {
  return (
    <button
      type={type}
      class={look}
      title={title}
      aria-disabled={waiting}
      onClick={(event) => (waiting ? event.preventDefault() : onAct?.())}
    >
      {children}
    </button>
  );
}
