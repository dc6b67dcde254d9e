// A view's landmark: its heading for a screen reader, and where the skip link leads.
import type { ComponentChildren } from "preact";
import "./main.css";

interface MainProps {
  name: string;
  class: string;
  hidden?: boolean;
  /** For style sheets: how it is arranged. */
  state?: string;
  children: ComponentChildren;
}

export function Main({ name, class: look, hidden, state, children }: MainProps) {
  return (
    <main class={look} aria-label={name} hidden={hidden} data-as={state} tabIndex={-1}>
      <h1 class="sr">{name}</h1>
      {children}
    </main>
  );
}

/** First in the page: past the top line to the view. A button, because the address names the view. */
export function SkipLink() {
  const skip = (): void => document.querySelector<HTMLElement>("main:not([hidden])")?.focus();
  return (
    <button type="button" class="skip" onClick={skip}>
      Skip to the view
    </button>
  );
}
