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
    .sort((a, b) => {
      const [going, other] = [a.state === "recording", b.state === "recording"];
      if (going !== other) return going ? -1 : 1;
      return b.recorded.localeCompare(a.recorded) || b.id.localeCompare(a.id);
    });
}
