// A mode's letter on its colour, small or as the badge of the present mode.
import type { ModeLook } from "../lib/modes";
import "./mode_mark.css";

export function ModeLetter({ mode }: { mode: ModeLook }) {
  return (
    <span class="mode-letter" data-mode={mode.key}>
      {mode.letter}
    </span>
  );
}

export function ModeBadge({ mode }: { mode: ModeLook }) {
  return (
    <span class="mode-badge" data-mode={mode.key} role="status" aria-label={`Mode ${mode.name}`}>
      {mode.letter}
    </span>
  );
}
