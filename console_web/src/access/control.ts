// Who holds control of the vehicle, whether it is this browser, and what can be done about it.
import { computed, signal } from "@preact/signals";
import { ask } from "../api/client";
import type { Answer, Refusal } from "../api/http";
import { me } from "../api/resources";
import type { ControlHolder } from "../gen/bumpless_pb";
import { live } from "../stream/store";

/** As the stream last said it. */
export const control = computed((): ControlHolder | undefined => live.latest("server/control"));

/** This browser holds control. */
export const holds = computed((): boolean => {
  const held = control.value?.holder;
  return held !== undefined && held !== "" && held === me.value?.client;
});

/** Somebody else holds control: starting, resuming and tuning are theirs. Pause and abort are everybody's. */
export const heldByOther = computed((): boolean => {
  const held = control.value?.holder;
  return held !== undefined && held !== "" && me.value !== undefined && held !== me.value.client;
});

/** This browser has asked for control. */
export const asked = computed((): boolean =>
  Boolean(control.value?.requests.some(({ client }) => client === me.value?.client)),
);

/** May give commands at all. Unknown until the server has said so: then it says no itself. */
export const commands = computed((): boolean => me.value?.role !== "observer");
export const tunes = computed((): boolean => me.value === undefined || me.value.role === "engineer");

export const NOT_YOURS = "Another operator is in control";
export const OBSERVES = "An observer gives no commands";

/** Why starting and resuming are not for this browser now; "" when they are. */
export const barred = computed((): string =>
  commands.value ? (heldByOther.value ? NOT_YOURS : "") : OBSERVES,
);

/** The last refusal of what is below. */
export const controlRefused = signal<Refusal | undefined>(undefined);

async function told(answer: Promise<Answer<unknown>>): Promise<boolean> {
  const got = await answer;
  controlRefused.value = got.ok ? undefined : got;
  return got.ok;
}

export const askForControl = (reason = ""): Promise<boolean> =>
  told(ask("post", "/api/control/ask", { body: { reason } }));
/** `reason`: at least three letters, read by everybody. */
export const takeControl = (reason: string): Promise<boolean> =>
  told(ask("post", "/api/control/take", { body: { reason } }));
export const handControl = (client: string): Promise<boolean> =>
  told(ask("post", "/api/control/hand", { body: { client } }));
export const declineControl = (client: string): Promise<boolean> =>
  told(ask("post", "/api/control/decline", { body: { client } }));
export const releaseControl = (): Promise<boolean> => told(ask("post", "/api/control/release"));
