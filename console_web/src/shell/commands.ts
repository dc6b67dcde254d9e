// What an operator can ask of the vehicle, and its answer as it came.
import { computed, signal } from "@preact/signals";
import { ask } from "../api/client";
import type { Answer, Refusal } from "../api/http";
import { once } from "../api/once";
import { missions } from "../api/resources";
import type { CommandReply } from "../api/types";
import { foreign, ownFirst } from "../stream/present";

export type Verb = "start" | "pause" | "resume" | "surface" | "abort";

const WORDS: Record<Verb, string> = {
  start: "Start",
  pause: "Hold",
  resume: "Resume",
  surface: "Surface",
  abort: "Abort",
};

export interface Notice {
  title: string;
  refusal: Refusal;
}

export const busy = signal<Verb | undefined>(undefined);
/** What is waited for before the next command can be given; "" for nothing. */
export const waits = computed((): string =>
  busy.value ? `The answer to ${WORDS[busy.value]} is awaited` : "",
);
/** The last refused command, until dismissed or until a command is accepted. */
export const notice = signal<Notice | undefined>(undefined);
/** The operator's choice, "" before there is one. */
export const chosen = signal("");
/** A choice on its way: a file is being stored. Until its answer nothing may start, least of all what was shown before. */
export const choosing = signal(false);
/** Name of the mission that is shown and that Start would fly: the choice while it exists, else this vehicle's first. */
export const mission = computed(() => {
  const list = missions.value;
  if (!list) return chosen.value;
  if (list.some(({ name }) => name === chosen.value)) return chosen.value;
  return ownFirst(list)[0]?.name ?? "";
});
/** Vehicle that the mission shown is for, when another one is on the bus; "" else. */
export const misfit = computed(() => {
  const shown = missions.value?.find(({ name }) => name === mission.value);
  return shown && foreign(shown) ? shown.vehicle : "";
});
/** As typed. */
export const seed = signal("");
export const seedRefused = computed(() => seed.value.trim() !== "" && !/^\d{1,9}$/.test(seed.value.trim()));

const TITLES: Record<Verb, string> = {
  start: "Start refused.",
  pause: "Pause refused.",
  resume: "Resume refused.",
  surface: "Surface refused.",
  abort: "Abort refused.",
};

/** Whether it was accepted; a refusal becomes the notice. */
async function told(verb: Verb, asked: Promise<Answer<CommandReply>>): Promise<boolean> {
  busy.value = verb;
  const answer = await asked;
  busy.value = undefined;
  notice.value = answer.ok ? undefined : { title: TITLES[verb], refusal: answer };
  return answer.ok;
}

export function command(verb: Exclude<Verb, "start">): Promise<boolean> {
  return told(verb, ask("post", "/api/mission/{verb}", { path: { verb }, body: {}, headers: once() }));
}

/** Fly the mission that is shown: by its hash, so that no other text under the same name can start. `despite`: what was found against it was read. */
export function startShown(shown: { name: string; sha256?: string }, despite = false): Promise<boolean> {
  const typed = seed.peek().trim();
  const fixed = typed === "" ? undefined : Number(typed);
  const body = {
    name: shown.name,
    ...(shown.sha256 ? { sha256: shown.sha256 } : {}),
    ...(fixed === undefined ? {} : { seed: fixed }),
    ...(despite ? { despite_findings: true } : {}),
  };
  return told("start", ask("post", "/api/mission/start", { body, headers: once() }));
}

export async function startChosen(): Promise<void> {
  const name = mission.peek();
  await startShown(missions.peek()?.find((entry) => entry.name === name) ?? { name });
}
