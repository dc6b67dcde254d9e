// What a draft would do: the server flies it ahead from where the vehicle is, beside what is in force.
import { computed, signal } from "@preact/signals";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import type { components } from "../gen/api";
import { history } from "../stream/history";
import { live } from "../stream/store";

export type WhatIf = components["schemas"]["WhatIf"];
export type AheadFlight = components["schemas"]["AheadFlight"];
export const HORIZONS_S = [15, 30, 60, 120, 300] as const;
/** The first flight of a server waits for a process, which may have to compile. */
const PATIENCE_MS = 130_000;

export const horizon_s = signal<number>(60);
export const flying = signal(false);
export const refused = signal<Refusal | undefined>(undefined);
/** The newest answer with what was asked. */
const told = signal<{ answer: WhatIf; draft: string } | undefined>(undefined);

/** The newest answer, while it is of the run that is flown. */
export const ahead = computed(() => {
  const run = live.latest("tlm/mission")?.runId;
  return told.value && told.value.answer.run === run ? told.value.answer : undefined;
});

/** Whether the answer is of another draft than this. */
export function isOther(parameters: object): boolean {
  return told.value !== undefined && told.value.draft !== JSON.stringify(parameters);
}

export async function flyAhead(parameters: object): Promise<void> {
  flying.value = true;
  const body = { parameters: parameters as Record<string, unknown>, horizon_s: horizon_s.value };
  const answer = await ask("post", "/api/what-if", { body, timeoutMs: PATIENCE_MS });
  flying.value = false;
  refused.value = answer.ok ? undefined : answer;
  if (answer.ok) told.value = { answer: answer.value, draft: JSON.stringify(parameters) };
}

export function forget(): void {
  told.value = undefined;
  refused.value = undefined;
}

/** Vehicle time, s, up to which the flights ahead reach; NaN without any. */
export function reach(): number {
  const last = ahead.value?.as_it_is.time_s.at(-1);
  return last === undefined ? Number.NaN : history.missionStart + last;
}

export interface AheadLine {
  name: "as it is" | "draft";
  time: number[];
  values: (number | null)[];
}

/** Lines of one column over vehicle time; angles beside the plotted one, which goes on past 360. */
export function linesOf(column: string): AheadLine[] {
  const answer = ahead.value;
  if (!answer) return [];
  const start = history.missionStart;
  return (
    [
      ["as it is", answer.as_it_is],
      ["draft", answer.draft],
    ] as const
  ).flatMap(([name, flight]) => {
    const values = flight.columns[column];
    if (!values) return [];
    const turns = column === "yaw" ? turnsTo(column, start + answer.from_s, values[0] ?? 0) : 0;
    return {
      name,
      time: flight.time_s.map((t) => start + t),
      values: values.map((value) => (value === null ? null : value + turns)),
    };
  });
}

function turnsTo(column: string, time: number, first: number): number {
  const at = Math.min(history.length - 1, history.firstIndex(time));
  const shown = history.column(column)?.[at];
  return shown === undefined || Number.isNaN(shown) ? 0 : 360 * Math.round((shown - first) / 360);
}
