// What an operator can ask of the vehicle, and its answer as it came.
import { computed, signal } from "@preact/signals";
import { ask } from "../api/client";
import type { Answer, Refusal } from "../api/http";
import { missions } from "../api/resources";
import type { CommandReply } from "../api/types";

export type Verb = "start" | "pause" | "resume" | "abort";

export interface Notice {
  title: string;
  refusal: Refusal;
}

export const busy = signal<Verb | undefined>(undefined);
/** The last refused command, until dismissed or until a command is accepted. */
export const notice = signal<Notice | undefined>(undefined);
/** The operator's choice, "" before there is one. */
export const chosen = signal("");
/** Name of the mission that is shown and that Start would fly. */
export const mission = computed(() => chosen.value || missions.value?.[0]?.name || "");
/** As typed. */
export const seed = signal("");

const TITLES: Record<Verb, string> = {
  start: "Start refused.",
  pause: "Pause refused.",
  resume: "Resume refused.",
  abort: "Abort refused.",
};

async function told(verb: Verb, asked: Promise<Answer<CommandReply>>): Promise<void> {
  busy.value = verb;
  const answer = await asked;
  busy.value = undefined;
  notice.value = answer.ok ? undefined : { title: TITLES[verb], refusal: answer };
}

export function command(verb: Exclude<Verb, "start">): Promise<void> {
  return told(verb, ask("post", "/api/mission/{verb}", { path: { verb }, body: {} }));
}

export function startChosen(): Promise<void> {
  const typed = seed.peek().trim();
  const body = { name: mission.peek(), ...(typed === "" ? {} : { seed: Number(typed) }) };
  return told("start", ask("post", "/api/mission/start", { body }));
}
