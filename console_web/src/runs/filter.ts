// Which flights of the list are shown: by words and by how they ended.
import type { RunSummary } from "../api/types";
import { asOne, type Flight, flightsOf } from "./flights";

export interface Filter {
  /** Each must be found somewhere in the flight. */
  words: string;
  /** An Ending's word; "" for all, "recording" for the one going on. */
  outcome: string;
}

function textOf({ pieces }: Flight): string {
  return pieces
    .flatMap((run) => [
      run.id,
      run.mission,
      run.title,
      run.note,
      run.vehicle,
      run.outcome_reason,
      ...run.tags,
    ])
    .join(" ")
    .toLowerCase();
}

/** Newest first by the server's clock: a vehicle's own may stand in 1970. */
export function shownFlights(list: readonly RunSummary[], filter: Filter): Flight[] {
  const words = filter.words.toLowerCase().split(/\s+/).filter(Boolean);
  return flightsOf(list)
    .map((flight) => ({ flight, one: asOne(flight) }))
    .filter(({ one }) => !filter.outcome || endOf(one) === filter.outcome)
    .filter(({ flight }) => {
      const text = textOf(flight);
      return words.every((word) => text.includes(word));
    })
    .sort((a, b) => newestFirst(a.one, b.one))
    .map(({ flight }) => flight);
}

function endOf(run: RunSummary): string {
  return run.state === "recording" ? run.state : (run.outcome ?? run.state);
}

function newestFirst(a: RunSummary, b: RunSummary): number {
  const [going, other] = [a.state === "recording", b.state === "recording"];
  if (going !== other) return going ? -1 : 1;
  return b.recorded.localeCompare(a.recorded) || b.id.localeCompare(a.id);
}
