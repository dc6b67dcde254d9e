// What the list of runs shows now: it stays while other views are looked at, and can be kept as a view for all.
import { batch, computed, effect, signal, untracked } from "@preact/signals";
import { ask } from "../api/client";
import type { Answer } from "../api/http";
import { Resource } from "../api/resource";
import type { components } from "../gen/api";
import { type Address, address, go } from "../shell/address";
import { ALL, type Column, USUAL } from "./columns";
import { asked, tell } from "./list_address";

export type RunView = components["schemas"]["RunViewAnswer"];
type Outcome = RunView["outcome"];

export const words = signal("");
export const outcome = signal<Outcome>("");
export const columns = signal<readonly Column[]>(USUAL);
export const runViews = new Resource(() => ask("get", "/api/run-views"));

/** The address is the list's own: neither a replay nor a comparison. */
function isList({ view, query }: Address): boolean {
  return view === "runs" && query.t === undefined && query.compare === undefined;
}

// A link brings the list as it was when it was copied; an address that says nothing leaves it as it is.
effect(() => {
  const at = address.value;
  const given = isList(at) ? asked(at.query) : undefined;
  if (!given) return;
  batch(() => {
    words.value = given.words;
    outcome.value = given.outcome;
    if (given.columns.join() !== columns.peek().join()) columns.value = given.columns;
  });
});

// And whatever the list shows stands in the address, so that a reload or a copied link keeps it.
effect(() => {
  const query = tell({ words: words.value, outcome: outcome.value, columns: columns.value });
  const at = address.value;
  if (isList(at)) untracked(() => go("runs", at.id, query, true));
});

/** Nothing is searched for, and the usual columns are shown. */
export const isUsual = computed(
  () => !words.value.trim() && !outcome.value && columns.value.join() === USUAL.join(),
);

/** The saved view that is shown as it was kept. */
export const shownView = computed(() =>
  runViews.value?.find(
    (view) =>
      view.words === words.value.trim() &&
      view.outcome === outcome.value &&
      columnsOf(view).join() === columns.value.join(),
  ),
);

function columnsOf(view: RunView): readonly Column[] {
  return view.columns.length ? view.columns : USUAL;
}

export function show(view: RunView | undefined): void {
  words.value = view?.words ?? "";
  outcome.value = view?.outcome ?? "";
  columns.value = view ? columnsOf(view) : USUAL;
}

/** Columns stand in one order, whoever chose them in which. */
export function toggle(column: Column): void {
  const chosen = columns.peek();
  columns.value = ALL.filter((one) => chosen.includes(one) !== (one === column));
}

/** What the last change of a view replaced or took away: it can be had back at once. */
export const undone = signal<{ text: string; view: RunView } | undefined>(undefined);

export async function keepView(name: string): Promise<Answer<unknown>> {
  const before = runViews.peek()?.find((view) => view.name === name);
  const answer = await put(name, { words: words.value, outcome: outcome.value, columns: [...columns.value] });
  if (answer.ok) undone.value = before && { text: `View ${name} was replaced.`, view: before };
  return answer;
}

export async function forgetView(view: RunView): Promise<Answer<unknown>> {
  const answer = await ask("delete", "/api/run-views/{name}", { path: { name: view.name } });
  if (answer.ok) undone.value = { text: `View ${view.name} is forgotten, for all.`, view };
  await runViews.refresh();
  return answer;
}

export async function takeViewBack(): Promise<Answer<unknown> | undefined> {
  const of = undone.peek()?.view;
  if (!of) return undefined;
  const answer = await put(of.name, { words: of.words, outcome: of.outcome, columns: of.columns });
  if (answer.ok) undone.value = undefined;
  return answer;
}

async function put(name: string, body: Pick<RunView, "words" | "outcome" | "columns">) {
  const answer = await ask("put", "/api/run-views/{name}", { path: { name }, body });
  await runViews.refresh();
  return answer;
}
