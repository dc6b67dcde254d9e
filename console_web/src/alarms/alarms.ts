// Alarms as the server keeps them, and what an operator can do with one.
import { computed, signal } from "@preact/signals";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import type { Alarm } from "../gen/bumpless_pb";
import { live } from "../stream/store";
import { priorityOf } from "./looks";

export type AlarmState = "unacknowledged" | "acknowledged" | "returned" | "shelved";

/** ISA-18.2: an alarm whose cause has gone stays until it has been seen. */
export function stateOf(alarm: Alarm, nowMs: number): AlarmState {
  if (Number(alarm.shelvedUntilNs) / 1e6 > nowMs) return "shelved";
  if (alarm.returnedNs) return "returned";
  return alarm.acknowledgedNs ? "acknowledged" : "unacknowledged";
}

const open = computed((): readonly Alarm[] => live.latest("server/alarms")?.alarms ?? []);

/** Every alarm that is not over, those to be seen first. */
export const alarms = computed((): readonly Alarm[] => {
  const now = Date.now();
  const rank = (alarm: Alarm): number => {
    const state = stateOf(alarm, now);
    return state === "shelved" ? 3 : alarm.acknowledgedNs ? 2 : 1;
  };
  return [...open.value].sort((a, b) => rank(a) - rank(b) || priorityOf(a) - priorityOf(b));
});

/** Those that somebody must still look at. */
export const unseen = computed(() =>
  alarms.value.filter((alarm) => !alarm.acknowledgedNs && stateOf(alarm, Date.now()) !== "shelved"),
);

/** Priority of the most urgent one that nobody has seen; 6 for none. */
export const worst = computed(() =>
  unseen.value.reduce((most, alarm) => Math.min(most, priorityOf(alarm)), 6),
);

/** The whole list is shown, with what is over. */
export const whole = signal(false);

export const refused = signal<Refusal | undefined>(undefined);

export async function acknowledge(alarm: Alarm): Promise<void> {
  const answer = await ask("post", "/api/alarms/{alarm}/acknowledge", {
    path: { alarm: alarm.id },
  });
  refused.value = answer.ok ? undefined : answer;
}

export async function shelve(alarm: Alarm, seconds: number): Promise<void> {
  const answer = await ask("post", "/api/alarms/{alarm}/shelve", {
    path: { alarm: alarm.id },
    body: { seconds },
  });
  refused.value = answer.ok ? undefined : answer;
}
