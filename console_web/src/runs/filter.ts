// Which runs of the list are shown: by words and by how they ended.
import type { RunSummary } from "../api/types";

export interface Filter {
  /** Each must be found somewhere in the run. */
  words: string;
  /** An Ending's word; "" for all, "recording" for the one going on. */
  outcome: string;
}

/** A hold after a mission is a piece of that flight: it is listed below it, and not judged. */
export function isPiece(run: RunSummary): boolean {
  return run.id !== run.run_id && run.id.startsWith(`${run.run_id}.`);
}

function textOf(run: RunSummary): string {
  return [run.id, run.mission, run.title, run.note, run.vehicle, run.outcome_reason, ...run.tags]
    .join(" ")
    .toLowerCase();
}

/** Newest first by the server's clock: a vehicle's own may stand in 1970. */
export function shownRuns(list: readonly RunSummary[], filter: Filter): RunSummary[] {
  const words = filter.words.toLowerCase().split(/\s+/).filter(Boolean);
  return list
    .filter((run) => !filter.outcome || (run.outcome ?? run.state) === filter.outcome)
    .filter((run) => {
      const text = textOf(run);
      return words.every((word) => text.includes(word));
    })
    .sort(newestFirst)
    .sort(byFlight(list));
}

function newestFirst(a: RunSummary, b: RunSummary): number {
  const [going, other] = [a.state === "recording", b.state === "recording"];
  if (going !== other) return going ? -1 : 1;
  return b.recorded.localeCompare(a.recorded) || b.id.localeCompare(a.id);
}

/** Pieces of one flight stand together, below its first, where its newest piece would stand. */
function byFlight(list: readonly RunSummary[]): (a: RunSummary, b: RunSummary) => number {
  const heads = new Map<string, RunSummary>();
  for (const run of list) {
    const head = heads.get(run.run_id);
    if (!head || newestFirst(run, head) < 0) heads.set(run.run_id, run);
  }
  return (a, b) =>
    a.run_id === b.run_id
      ? pieceOf(a) - pieceOf(b)
      : newestFirst(heads.get(a.run_id) ?? a, heads.get(b.run_id) ?? b);
}

/** 1 for a flight's first piece. */
export function pieceOf(run: RunSummary): number {
  return isPiece(run) ? Number(run.id.slice(run.run_id.length + 1)) || 1 : 1;
}

/** All pieces of the flight that a run is of, in order. */
export function piecesOf(list: readonly RunSummary[], run: RunSummary): RunSummary[] {
  return list.filter(({ run_id }) => run_id === run.run_id).sort((a, b) => pieceOf(a) - pieceOf(b));
}
