// On which headings the vehicle holds station in the current that it estimates: asked while somebody looks.
import { computed, signal } from "@preact/signals";
import { ask } from "../api/client";
import type { Held } from "../lib/held";
import { link, phase } from "../stream/link";
import { isInForce } from "../stream/phase";
import { live } from "../stream/store";

const EACH_MS = 1500;
/** Changes of the estimate that are worth asking again for, m/s. */
const STEP_MPS = 0.005;

const told = signal<Held | undefined>(undefined);
const flies = computed(() => link.value.look === "live" && isInForce(phase.value));

/** What was told last; undefined where nothing flies, or is heard. */
export const heldNow = computed(() => (flies.value ? told.value : undefined));

/** What the answer depends on, so far as the screen knows it. */
function about(): string {
  const flow = live.latest("tlm/navigation")?.currentEstimateNedMps;
  const steps = [flow?.x, flow?.y].map((part) => Math.round((part ?? 0) / STEP_MPS));
  const heading = Math.round(live.latest("tlm/target")?.headingDeg ?? 0);
  return [
    ...steps,
    heading,
    live.latest("tlm/supervisor")?.dockingStage,
    live.latest("tlm/mission")?.runId,
    live.latest("tlm/parameters")?.revision,
  ].join();
}

let asked = "";
let asking = false;

async function look(): Promise<void> {
  if (!flies.peek()) {
    told.value = undefined;
    asked = "";
    return;
  }
  const now = about();
  if (asking || now === asked || document.hidden) return;
  asking = true;
  const answer = await ask("get", "/api/vehicle/station", {});
  asking = false;
  asked = answer.ok ? now : "";
  told.value = answer.ok ? (answer.value ?? undefined) : undefined;
}

let lookers = 0;
let timer: ReturnType<typeof setInterval> | undefined;

/** Keep it up to date while somebody looks; returns how to stop. */
export function watchStation(): () => void {
  lookers += 1;
  timer ??= setInterval(() => void look(), EACH_MS);
  void look();
  return () => {
    lookers -= 1;
    if (lookers) return;
    clearInterval(timer);
    timer = undefined;
  };
}
