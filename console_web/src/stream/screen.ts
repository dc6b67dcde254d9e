// What the Live view shows: the stream, or a recorded run in its place. The bar above it is always live.
import { computed, signal } from "@preact/signals";
import { type Event, MissionPhase, type Mode } from "../gen/bumpless_pb";
import { type History, history } from "./history";
import { flownMode, isFlying, isInForce } from "./phase";
import { live } from "./store";
import type { MessageOf, TopicName } from "./topics";

/** Where shown values come from. */
export interface Source {
  latest<K extends TopicName>(name: K): MessageOf<K> | undefined;
  isFresh(name: TopicName): boolean;
  age(name: TopicName): number | undefined;
  readonly events: readonly Event[];
  readonly now: { readonly value: number };
}

interface Shown {
  source: Source;
  history: History;
  /** Vehicle time that the plots end with, s; NaN: the newest row. */
  until: () => number;
}

/** Vehicle time that the live plots are held at, s; NaN: they follow the present. */
export const heldAt = signal(Number.NaN);

const LIVE: Shown = { source: live, history, until: () => heldAt.value };
const shown = signal<Shown>(LIVE);

export function showRun(run: Shown): void {
  shown.value = run;
}

export function showLive(): void {
  shown.value = LIVE;
}

export const screen = {
  latest: <K extends TopicName>(name: K): MessageOf<K> | undefined => shown.value.source.latest(name),
  isFresh: (name: TopicName): boolean => shown.value.source.isFresh(name),
  age: (name: TopicName): number | undefined => shown.value.source.age(name),
  get events(): readonly Event[] {
    return shown.value.source.events;
  },
  /** Changes whenever there is something new to draw. */
  get tick(): number {
    return shown.value.source.now.value;
  },
  get history(): History {
    return shown.value.history;
  },
  /** Vehicle time at the right edge of the plots, s. */
  get until(): number {
    const until = shown.value.until();
    return Number.isNaN(until) ? shown.value.history.last() : until;
  },
  get isLive(): boolean {
    return shown.value === LIVE;
  },
};

export const shownPhase = computed(
  (): MissionPhase =>
    screen.latest("tlm/supervisor")?.phase || screen.latest("tlm/mission")?.phase || MissionPhase.UNSPECIFIED,
);
export const shownFlying = computed(() => isFlying(shownPhase.value));
/** Demands, ranges and solutions on the screen are of this cycle, and not left over. */
export const inForce = computed(() => isInForce(shownPhase.value));
export const shownMode = computed((): Mode => flownMode(screen.latest("tlm/supervisor"), shownPhase.value));
