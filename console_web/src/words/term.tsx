// A word or symbol that explains itself when pressed, by pointer, touch or keyboard.
import type { ComponentChildren } from "preact";
import { type Asked, open } from "./asked";
import "./term.css";

export function Term({ of, children }: { of: Asked["word"]; children: ComponentChildren }) {
  return (
    <button
      type="button"
      class="term"
      aria-haspopup="dialog"
      data-word={of}
      onClick={(event) => {
        event.stopPropagation();
        open({ word: of, at: event.currentTarget });
      }}
    >
      {children}
    </button>
  );
}
