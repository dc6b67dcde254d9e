// What of the words is asked for now: one word beside where it stands, the glossary, or the palette.
import { signal } from "@preact/signals";
import type { WordId } from "./words";

export interface Asked {
  word: WordId;
  at: HTMLElement;
}
export type Sheet = "glossary" | "palette";

export const asked = signal<Asked | undefined>(undefined);
export const sheet = signal<Sheet | undefined>(undefined);

export function open(next: Asked): void {
  asked.value = next;
}

const typing = (target: EventTarget | null): boolean =>
  target instanceof HTMLElement &&
  (target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName));

/** The two keys that work everywhere. */
export function onKey(event: KeyboardEvent): void {
  if (event.defaultPrevented) return;
  const command = event.ctrlKey || event.metaKey;
  if (command && !event.altKey && event.key.toLowerCase() === "k") {
    event.preventDefault();
    sheet.value = sheet.peek() === "palette" ? undefined : "palette";
  } else if (event.key === "?" && !command && !typing(event.target) && !sheet.peek()) {
    event.preventDefault();
    sheet.value = "glossary";
  }
}
