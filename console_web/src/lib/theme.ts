// Dark or light: the system's choice until the operator makes one.
import { invalidate } from "../stream/frame";

export type Theme = "dark" | "light";
const KEY = "bumpless.theme";
let colours: Record<string, string> = {};

export function theme(): Theme {
  return document.documentElement.dataset.theme === "light" ? "light" : "dark";
}

export function setTheme(next: Theme): void {
  document.documentElement.dataset.theme = next;
  colours = {};
  try {
    localStorage.setItem(KEY, next);
  } catch {
    // Without storage the choice lasts as long as the page.
  }
  for (const listener of listeners) listener();
  invalidate();
}

const listeners = new Set<() => void>();
export function onTheme(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** A colour token of the style sheet, for canvases; read once per theme. */
export function colour(token: string): string {
  return (colours[token] ??= getComputedStyle(document.documentElement).getPropertyValue(token).trim());
}
