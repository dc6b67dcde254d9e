// The page's address after "#": "#/view", "#/view/id", "#/view/id?key=value". One place reads and writes it.
// The short form "#view" of older bookmarks is understood as well.
import { signal } from "@preact/signals";

export interface Address {
  view: string;
  /** What of the view, "" for none: a run, a mission. */
  id: string;
  query: Readonly<Record<string, string>>;
}

export function addressOf(hash: string): Address {
  const [path = "", query = ""] = hash.replace(/^#?\/?/, "").split(/\?(.*)/s);
  const [view = "", ...rest] = path.split("/");
  return { view, id: decoded(rest.join("/")), query: Object.fromEntries(new URLSearchParams(query)) };
}

/** For a link: `href("runs", id, { t: 31.2 })`. What is undefined or "" is left out. */
export function href(view: string, id = "", query: Record<string, string | number | undefined> = {}): string {
  const pairs = Object.entries(query).filter(([, value]) => value !== undefined && value !== "");
  const told = new URLSearchParams(pairs.map(([name, value]) => [name, String(value)]));
  return `#/${view}${id && `/${encodeURIComponent(id)}`}${pairs.length ? `?${told}` : ""}`;
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text; // typed by hand
  }
}

const here = (): string => (typeof location === "undefined" ? "" : location.hash);

/** Where the page is. */
export const address = signal<Address>(addressOf(here()));

/** Go there; `replace`: without a step in the browser's history. */
export function go(
  view: string,
  id = "",
  query: Record<string, string | number | undefined> = {},
  replace = false,
): void {
  const to = href(view, id, query);
  if (to === location.hash) return;
  if (replace) history.replaceState(history.state, "", to);
  else history.pushState(null, "", to);
  address.value = addressOf(to);
}

if (typeof addEventListener === "function") {
  for (const name of ["hashchange", "popstate"]) {
    addEventListener(name, () => {
      address.value = addressOf(here());
    });
  }
}
