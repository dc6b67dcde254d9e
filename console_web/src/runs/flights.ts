// Flights out of the list of files: the pieces that a crash, a full disk or the hold after a mission made of one
// are listed as one. The files themselves stay as they are, for tools.
import type { RunSummary } from "../api/types";

export interface Flight {
  /** The first piece: its id, title, tags and note are the flight's. */
  head: RunSummary;
  /** In order; one for nearly every flight. */
  pieces: RunSummary[];
  /** Pieces of the mission that are over and judged: a hold after it is none. */
  flown: RunSummary[];
  /** The piece being recorded now. */
  growing: RunSummary | undefined;
  /** What is being recorded is the hold after a mission that is over. */
  holds: boolean;
}

/** A run, or a copy of one, is a flight of its own. */
function keyOf(run: RunSummary): string {
  return run.piece ? `flight ${run.run_id}` : run.id;
}

export function flightsOf(list: readonly RunSummary[]): Flight[] {
  const found = new Map<string, RunSummary[]>();
  for (const run of list) found.set(keyOf(run), [...(found.get(keyOf(run)) ?? []), run]);
  return [...found.values()].map(flightOf);
}

function flightOf(files: RunSummary[]): Flight {
  const pieces = files.sort((a, b) => a.piece - b.piece);
  const flown = pieces.filter(({ state, outcome }) => state !== "recording" && outcome);
  const growing = pieces.find(({ state }) => state === "recording");
  const ended = flown.at(-1)?.outcome;
  const holds = growing !== undefined && ended !== undefined && ended !== "interrupted";
  return { head: pieces[0] as RunSummary, pieces, flown, growing, holds };
}

/** The flight as one line of the list: the end of its last piece, whatever a hold or a first piece says. */
export function asOne({ head, pieces, flown, growing, holds }: Flight): RunSummary {
  if (pieces.length === 1) return head;
  const last = flown.find(({ outcome }) => outcome === "collided") ?? flown.at(-1) ?? head;
  const sum = (of: (piece: RunSummary) => number): number => pieces.reduce((all, p) => all + of(p), 0);
  return {
    ...head,
    state: growing && !holds ? "recording" : last.state,
    outcome: last.outcome,
    outcome_reason: last.outcome_reason,
    end_reason: last.end_reason,
    duration_s: Math.max(...(flown.length ? flown : pieces).map((piece) => piece.duration_s ?? 0)),
    bytes: sum(({ bytes }) => bytes),
    messages: sum(({ messages }) => messages),
    dropped: sum(({ dropped }) => dropped),
    recorded:
      pieces
        .map(({ recorded }) => recorded)
        .sort()
        .at(-1) ?? head.recorded,
  };
}
