// Two to six runs: what the server says of their differences, and their lines laid over each other.
import { signal } from "@preact/signals";
import { address, ask } from "../api/client";
import type { Answer } from "../api/http";
import { runs } from "../api/resources";
import type { components } from "../gen/api";
import { framesOf, rowsOf } from "../replay/frames";
import { flightsOf } from "../runs/flights";
import type { CycleRow } from "../stream/cycle_row";

export type Comparison = components["schemas"]["ComparisonAnswer"];
export type Moment = "start" | "reverse" | "hover" | "end";
export const MOMENTS: { value: Moment; name: string; about: string }[] = [
  { value: "start", name: "Start", about: "Mission time 0" },
  { value: "reverse", name: "To R", about: "The first switch to reverse" },
  { value: "hover", name: "To H", about: "The first switch to hover: docking begins" },
  { value: "end", name: "End", about: "The last cycle" },
];
export const MOST = 6;
const ROWS = 900;
/** As many times a run's usual step without a row are a gap. */
const GAP_STEPS = 5;
/** How runs are told apart beside their colour. */
export const DASHES: number[][] = [[], [8, 4], [2, 3], [10, 3, 2, 3], [5, 5], [1, 2]];

export const letterOf = (index: number): string => String.fromCharCode(65 + index);

/** The runs that an address names: "A,B". */
export function idsOf(text: string | undefined): string[] {
  return [...new Set((text ?? "").split(",").filter(Boolean))].slice(0, MOST);
}

export const comparison = signal<Answer<Comparison> | undefined>(undefined);
/** Rows of each run, in order; empty until they have come. */
export const rows = signal<CycleRow[][]>([]);
/** Those whose lines cannot be read, by letter; they are left out of plots and scene. */
export const unread = signal("");
let turn = 0;

export async function load(ids: string[]): Promise<void> {
  const mine = ++turn;
  comparison.value = undefined;
  rows.value = [];
  unread.value = "";
  const query = new URLSearchParams(ids.map((id) => ["run", id]));
  const answer = await ask("get", `/api/compare?${query}` as "/api/compare");
  if (mine !== turn) return;
  comparison.value = answer;
  if (!answer.ok) return;
  const found = await Promise.all(ids.map(rowsOfRun));
  if (mine !== turn) return;
  unread.value = found.flatMap((own, k) => (own ? [] : [letterOf(k)])).join(", ");
  rows.value = found.map((own) => own ?? []);
}

/** A flight without the hold after its mission; undefined when it cannot be read. */
export async function rowsOfRun(run: string): Promise<CycleRow[] | undefined> {
  const about = await ask("get", "/api/runs/{run}/replay", { path: { run } });
  if (!about.ok) return undefined;
  const { first_s, last_s, pieces } = about.value;
  const flown = flightsOf(runs.peek() ?? []).find((flight) =>
    flight.pieces.some(({ id }) => id === run),
  )?.flown;
  const end = pieces.find(({ id }) => id === flown?.at(-1)?.id)?.last_s ?? last_s;
  const range = { from_s: first_s, to_s: end, most: ROWS };
  try {
    const response = await fetch(address("/api/runs/{run}/frames", { run }, range));
    return response.ok ? rowsOf(framesOf(await response.arrayBuffer())) : undefined;
  } catch {
    return undefined; // out of reach, or gone with the page
  }
}

/** Lines of one signal over time from a moment: one x axis for all, nothing where a run has no row. */
export function lines(
  runs: CycleRow[][],
  moments: Record<string, number>[],
  align: Moment,
  column: string,
): [number[], ...(number | null)[][]] {
  const step = 0.1;
  const tables = runs.map((run, k) => {
    const zero = moments[k]?.[align] ?? 0;
    const table = new Map<number, number | null>();
    for (const { missionTime, row, inForce } of run) {
      if (!inForce) continue;
      const value = row[column];
      table.set(
        Math.round((missionTime - zero) / step),
        value == null || !Number.isFinite(value) ? null : value,
      );
    }
    return table;
  });
  const ticks = [...new Set(tables.flatMap((table) => [...table.keys()]))].sort((a, b) => a - b);
  return [ticks.map((tick) => tick * step), ...tables.map((table) => filled(ticks, table))];
}

/** A run that is sampled more coarsely keeps its line from row to row, but over no gap of what was recorded. */
function filled(ticks: number[], table: Map<number, number | null>): (number | null)[] {
  const own = [...table.keys()].sort((a, b) => a - b);
  const steps = own.slice(1).map((tick, k) => tick - (own[k] as number));
  const usual = steps.toSorted((a, b) => a - b)[steps.length >> 1] ?? 1;
  const [first, last] = [own[0] ?? 0, own.at(-1) ?? -1];
  let before: number | null = null;
  let at = first;
  return ticks.map((tick) => {
    if (tick < first || tick > last) return null;
    if (table.has(tick)) [before, at] = [table.get(tick) ?? null, tick];
    return tick - at < GAP_STEPS * usual ? before : null;
  });
}
