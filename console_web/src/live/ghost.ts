// A second line beside the measured one: an earlier run, or the forecast of the mission that is flown. Aligned
// on mission time 0.
import { signal } from "@preact/signals";
import { wrapDegrees } from "../stream/history";
import { screen } from "../stream/screen";
import type { Flown } from "./ghost_sources";

/** A line of another flight under the name that was chosen: FORECAST, or the run's id. */
export type Ghost = Flown & { name: string };

export const FORECAST = "forecast";
export const ghost = signal<Ghost | undefined>(undefined);
/** What was chosen: FORECAST, a run's id, or "" for none; and why it is not there. */
export const haunted = signal("");
export const trouble = signal("");

let turn = 0;

export async function haunt(choice: string): Promise<void> {
  const mine = ++turn;
  haunted.value = choice;
  ghost.value = undefined;
  trouble.value = "";
  if (!choice) return;
  try {
    const { earlierRun, forecast } = await import("./ghost_sources");
    const found = await (choice === FORECAST ? forecast() : earlierRun(choice));
    if (mine === turn) ghost.value = { name: choice, ...found };
  } catch (error) {
    if (mine === turn) trouble.value = error instanceof Error ? error.message : "not available";
  }
}

/** The ghost's value at a mission time; null outside it. A heading is told near `beside`, so that no line jumps. */
export function at(of: Ghost, column: string, missionTime: number, beside?: number | null): number | null {
  const values = of.columns[column];
  const [first, last] = [of.time[0], of.time.at(-1)];
  if (!values || first === undefined || last === undefined) return null;
  if (!(missionTime >= first && missionTime <= last)) return null;
  let low = 0;
  let high = of.time.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((of.time[middle] as number) <= missionTime) low = middle;
    else high = middle - 1;
  }
  const value = values[low] ?? null;
  return value !== null && beside != null ? beside + wrapDegrees(value - beside) : value;
}

/** The ghost at each of these vehicle times, for a plot. */
export function ghostLine(
  column: string,
  times: ArrayLike<number>,
  heading?: ArrayLike<number | null | undefined>,
): (number | null)[] {
  const of = ghost.value;
  const start = screen.history.missionStart;
  return Array.from(times, (time, i) => (of ? at(of, column, time - start, heading?.[i]) : null));
}
