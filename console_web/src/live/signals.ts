// Which plots are shown: a group, or the operator's own choice, which is kept with its named layouts.
import { computed, effect, signal } from "@preact/signals";
import { everySpec, GROUPS, type Group, type PlotSpec, specsOf } from "./plots";

const KEY = "bumpless.plots";
const MOST = 12;
const FIRST = ["depth", "range", "kappa"];

interface Kept {
  group: Group;
  own: string[];
  layouts: Record<string, string[]>;
}

/** What storage holds, whoever wrote it. */
export function read(text: string | null): Kept {
  const kept: Kept = { group: "Motion", own: FIRST, layouts: {} };
  try {
    const found = JSON.parse(text ?? "null") as Partial<Kept> | null;
    if (found?.group && GROUPS.includes(found.group)) kept.group = found.group;
    if (Array.isArray(found?.own)) kept.own = names(found.own);
    for (const [name, ids] of Object.entries(found?.layouts ?? {}))
      if (Array.isArray(ids)) kept.layouts[name] = names(ids);
  } catch {
    // Not ours, or torn: the defaults.
  }
  return kept;
}

function names(list: unknown[]): string[] {
  return list.filter((id): id is string => typeof id === "string").slice(0, MOST);
}

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

const start = read(typeof localStorage === "undefined" ? null : stored());
export const group = signal<Group>(start.group);
export const own = signal<readonly string[]>(start.own);
export const layouts = signal<Readonly<Record<string, readonly string[]>>>(start.layouts);

effect(() => {
  const kept = JSON.stringify({ group: group.value, own: own.value, layouts: layouts.value });
  try {
    localStorage.setItem(KEY, kept);
  } catch {
    // Without storage the layout lasts as long as the page.
  }
});

export const signals = everySpec;

/** Specs that are shown now; a signal that this vehicle does not have is left out. */
export const shownSpecs = computed((): PlotSpec[] => {
  if (group.value !== "Own") return specsOf(group.value);
  const all = new Map(everySpec().map((spec) => [spec.id, spec]));
  return own.value.flatMap((id) => all.get(id) ?? []);
});

export function toggleSignal(id: string): void {
  own.value = own.peek().includes(id)
    ? own.peek().filter((other) => other !== id)
    : [...own.peek(), id].slice(-MOST);
}

/** Put a signal among the operator's own, and show them. */
export function showSignal(id: string): void {
  if (!own.peek().includes(id)) toggleSignal(id);
  group.value = "Own";
}

export function saveLayout(name: string): void {
  const called = name.trim().slice(0, 40);
  if (called) layouts.value = { ...layouts.peek(), [called]: own.peek() };
}

export function dropLayout(name: string): void {
  layouts.value = Object.fromEntries(Object.entries(layouts.peek()).filter(([other]) => other !== name));
}
