// What an operator can ask of the vehicle, and its answer as it came.
import { request, type Answer, type Refusal } from "../api/http";
import type { CommandReply } from "../api/types";
import { invalidate } from "../stream/frame";

export type Verb = "start" | "pause" | "resume" | "abort";

export interface Notice {
  title: string;
  refusal: Refusal;
}

/** The last refused command, until dismissed or until a command is accepted. */
export const commandState: { busy: Verb | undefined; notice: Notice | undefined; chosen: string; seed: string } = {
  busy: undefined,
  notice: undefined,
  chosen: "",
  seed: "",
};

const TITLES: Record<Verb, string> = {
  start: "Start refused.",
  pause: "Pause refused.",
  resume: "Resume refused.",
  abort: "Abort refused.",
};

export async function command(verb: Verb, body: object = {}): Promise<Answer<CommandReply>> {
  commandState.busy = verb;
  invalidate();
  const answer = await request<CommandReply>("POST", `api/mission/${verb}`, body);
  commandState.busy = undefined;
  commandState.notice = answer.ok ? undefined : { title: TITLES[verb], refusal: answer };
  invalidate();
  return answer;
}

export function startChosen(): Promise<Answer<CommandReply>> {
  const seed = commandState.seed.trim();
  return command("start", { name: commandState.chosen, ...(seed === "" ? {} : { seed: Number(seed) }) });
}

export function choose(name: string): void {
  commandState.chosen = name;
  invalidate();
}
