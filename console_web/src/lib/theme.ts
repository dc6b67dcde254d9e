// Dark or light: the system's choice until the operator makes one. Colours and type for canvases.
import { signal } from "@preact/signals";

export type Theme = "dark" | "light";
const KEY = "bumpless.theme";
const root = document.documentElement;

export const theme = signal<Theme>(root.dataset.theme === "light" ? "light" : "dark");
/** Size of the page's type, px: grows with the screen and with the browser's own setting. */
export const typeSize = signal(rootSize());
let tokens: Record<string, string> = {};

let chosen = stored() !== null;

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null; // Without storage the choice lasts as long as the page.
  }
}

export function setTheme(next: Theme): void {
  chosen = true;
  try {
    localStorage.setItem(KEY, next);
  } catch {
    // As above.
  }
  wear(next);
}

function wear(next: Theme): void {
  root.dataset.theme = next;
  tokens = {};
  theme.value = next;
}

// A system that turns dark in the evening takes the page along.
matchMedia("(prefers-color-scheme: light)").addEventListener("change", ({ matches }) => {
  if (!chosen) wear(matches ? "light" : "dark");
});

function rootSize(): number {
  return Number.parseFloat(getComputedStyle(root).fontSize);
}

addEventListener("resize", () => {
  typeSize.value = rootSize();
});

/** A token of the style sheets; read once per theme. */
function token(name: string): string {
  tokens[name] ??= getComputedStyle(root).getPropertyValue(name).trim();
  return tokens[name];
}

/** A colour of the style sheets, for canvases. */
export function colour(name: string): string {
  return token(name);
}

/** A font of the style sheets' type scale, for canvases. */
export function font(size: string, weight = 400, scale = 1): string {
  return `${weight} ${Number.parseFloat(token(size)) * typeSize.peek() * scale}px ${token("--font")}`;
}
