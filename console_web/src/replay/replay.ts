// A recorded run in the place of the stream: one moment at a time, found by the server, played from blocks of
// frames that are fetched ahead. Memory is bounded: one block, one overview, one stretch in detail.
import { create, fromBinary } from "@bufbuild/protobuf";
import { computed, type Signal, signal } from "@preact/signals";
import { address, ask } from "../api/client";
import type { components } from "../gen/api";
import { type Event, EventSchema, Severity, type StreamFrame, StreamFrameSchema } from "../gen/bumpless_pb";
import { FRESH_FOR_S } from "../gen/house";
import type { CycleRow } from "../stream/cycle_row";
import { GAP, History } from "../stream/history";
import type { Source } from "../stream/screen";
import type { MessageOf, TopicName } from "../stream/topics";
import { framesOf, merged, rowsOf, type Sample, samplesOf } from "./frames";

type About = components["schemas"]["ReplayAnswer"];
export type Gap = readonly [from: number, to: number];

const OVERVIEW = 900;
const DETAIL_S = 120;
const DETAIL = 1500;
const DETAIL_AFTER_MS = 250;
/** Mission times closer than this are of one cycle, s. */
const STEP_S = 0.02;
/** Seconds of the run in a block, at a speed of 1. */
const BLOCK_S = 10;
export const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16] as const;

interface Block {
  from: number;
  to: number;
  frames: StreamFrame[];
  /** Frames shown already. */
  next: number;
}

export class Replay implements Source {
  /** Mission time that is shown, s. */
  readonly t = signal(0);
  readonly playing = signal(false);
  readonly speed = signal<number>(1);
  readonly about = signal<About | undefined>(undefined);
  readonly trouble = signal("");
  readonly now: Signal<number> = signal(0);
  readonly history = new History();
  /** Grows whenever the rows of `history`, or what is known beside them, have changed. */
  readonly plotted = signal(0);
  private readonly samples = new Map<TopicName, Sample>();
  private all: Event[] = [];
  private overview: CycleRow[] = [];
  private detail: [from: number, to: number] = [0, -1];
  private block: Block | undefined;
  private fetching = false;
  private wanted: number | undefined;
  private seeking: Promise<void> | undefined;
  /** Server time at mission time 0, s. */
  private origin = Number.NaN;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private frameAt = 0;
  private closed = false;

  constructor(readonly run: string) {}

  readonly events_ = computed((): readonly Event[] => {
    const t = this.t.value;
    return this.all.filter((event) => (event.stamp?.missionTimeS ?? 0) <= t).reverse();
  });

  get events(): readonly Event[] {
    void this.about.value;
    return this.events_.value;
  }

  get every(): readonly Event[] {
    return this.about.value ? this.all : [];
  }

  get first(): number {
    return this.about.value?.first_s ?? 0;
  }

  get last(): number {
    return this.about.value?.last_s ?? 0;
  }

  /** What was not recorded, mission times. */
  get gaps(): readonly Gap[] {
    return (this.about.value?.gaps ?? []).map((gap) => [gap.first_s ?? 0, gap.last_s ?? 0] as const);
  }

  /** The gap that the playhead is in. */
  readonly gap = computed(() => this.gaps.find(([from, to]) => this.t.value > from && this.t.value < to));

  /** From one cycle to the next at a mission time: a hold is recorded more rarely than a mission, s. */
  private paceAt(t: number): number {
    const pieces = this.about.peek()?.pieces ?? [];
    const piece = pieces.findLast(({ first_s }) => (first_s ?? 0) <= t) ?? pieces[0];
    return piece?.pace_s ?? 0;
  }

  latest<K extends TopicName>(name: K): MessageOf<K> | undefined {
    void this.now.value;
    return this.samples.get(name)?.message as MessageOf<K> | undefined;
  }

  age(name: TopicName): number | undefined {
    void this.now.value;
    const sample = this.samples.get(name);
    return sample && Math.max(0, this.origin + this.t.peek() - sample.at);
  }

  isFresh(name: TopicName): boolean {
    const age = this.age(name);
    return age !== undefined && age <= Math.max(FRESH_FOR_S[name], 1.5 * this.paceAt(this.t.peek()));
  }

  /** Vehicle time at the playhead, s. */
  until(): number {
    void this.now.value;
    return this.history.missionStart + this.t.peek();
  }

  async open(t: number): Promise<void> {
    const answer = await ask("get", "/api/runs/{run}/replay", { path: { run: this.run } });
    if (!answer.ok) {
      this.trouble.value = answer.reason;
      return;
    }
    this.all = answer.value.events.map(eventOf);
    this.about.value = answer.value;
    await Promise.all([this.seek(t), this.look()]);
  }

  close(): void {
    this.closed = true;
    this.playing.value = false;
    clearTimeout(this.timer);
  }

  /** Show another moment; of several asked for in a hurry the last counts. */
  seek(t: number): Promise<void> {
    const to = Math.min(this.last, Math.max(this.first, t));
    this.t.value = to;
    this.now.value++;
    this.wanted = to;
    this.seeking ??= this.find().finally(() => {
      this.seeking = undefined;
    });
    return this.seeking;
  }

  private async find(): Promise<void> {
    while (this.wanted !== undefined) {
      const t = this.wanted;
      this.wanted = undefined;
      const data = await this.fetch("at", { t });
      if (!data) return;
      const frame = fromBinary(StreamFrameSchema, new Uint8Array(data));
      this.origin = Number(frame.serverTimeNs) / 1e9 - Math.max(t, this.first);
      this.samples.clear();
      this.take(frame);
      this.block = undefined;
      this.now.value++;
      this.plotted.value++;
    }
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.lookCloser(), DETAIL_AFTER_MS);
  }

  play(): void {
    if (this.playing.value || !this.about.value) return;
    if (this.t.value >= this.last) void this.seek(this.first);
    this.playing.value = true;
    this.frameAt = performance.now();
    requestAnimationFrame(() => this.advance());
  }

  pause(): void {
    this.playing.value = false;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.lookCloser(), DETAIL_AFTER_MS);
  }

  /** One animation frame of playing: never past what has come. */
  private advance(): void {
    if (!this.playing.peek() || this.closed) return;
    const now = performance.now();
    const passed = ((now - this.frameAt) / 1000) * this.speed.peek();
    this.frameAt = now;
    const block = this.block;
    if (block && !this.seeking) {
      const to = Math.min(this.t.peek() + passed, block.to, this.last);
      while (block.next < block.frames.length && this.timeOf(block.frames[block.next]) <= to) {
        this.take(block.frames[block.next++] as StreamFrame);
      }
      this.t.value = to;
      this.now.value++;
      if (to >= this.last) this.pause();
      const [from, end] = this.detail;
      if (to < from || to > end) void this.lookCloser();
    }
    const ahead = (block?.to ?? Number.NEGATIVE_INFINITY) - this.t.peek();
    if (!block || ahead <= 0) void this.fetchBlock();
    requestAnimationFrame(() => this.advance());
  }

  private timeOf(frame: StreamFrame | undefined): number {
    return frame ? Number(frame.serverTimeNs) / 1e9 - this.origin : Number.POSITIVE_INFINITY;
  }

  private async fetchBlock(): Promise<void> {
    if (this.fetching || this.seeking) return;
    this.fetching = true;
    const from = this.t.peek();
    const to = from + BLOCK_S * Math.max(1, this.speed.peek());
    const data = await this.fetch("frames", { from_s: from, to_s: to, most: 4000 });
    this.fetching = false;
    if (data && !this.seeking) this.block = { from, to, frames: framesOf(data), next: 0 };
  }

  private take(frame: StreamFrame): void {
    for (const [topic, sample] of samplesOf(frame)) this.samples.set(topic, sample);
  }

  /** The whole run, thinned, for plots and scrubber. */
  private async look(): Promise<void> {
    const data = await this.fetch("frames", { from_s: this.first, to_s: this.last, most: OVERVIEW });
    if (!data) return;
    this.overview = rowsOf(framesOf(data));
    this.plot([]);
  }

  /** The stretch around the playhead in detail, where the overview is too coarse. */
  private async lookCloser(): Promise<void> {
    const cycles = this.about.value?.cycles ?? 0;
    const t = this.t.peek();
    if (cycles <= OVERVIEW || this.closed) return;
    const [from, to] = [t - DETAIL_S, t + DETAIL_S / 4];
    if (t - Math.min(DETAIL_S, t - this.first) >= this.detail[0] && t <= this.detail[1] - 1) return;
    this.detail = [from, to];
    const data = await this.fetch("frames", { from_s: from, to_s: to, most: DETAIL });
    if (data) this.plot(rowsOf(framesOf(data)));
  }

  private plot(detail: CycleRow[]): void {
    const step = (this.last - this.first) / Math.max(1, this.overview.length);
    this.history.clear();
    let before = Number.NaN;
    for (const row of merged(this.overview, detail)) {
      const t = row.missionTime;
      if (this.gaps.some(([from, to]) => before <= from + STEP_S && t >= to - STEP_S))
        this.history.breakOff();
      this.history.gap = Math.max(GAP, 3 * step, 3 * this.paceAt(t));
      this.history.append(row);
      before = t;
    }
    this.now.value++;
    this.plotted.value++;
  }

  private async fetch(what: "at" | "frames", query: object): Promise<ArrayBuffer | undefined> {
    try {
      const response = await fetch(address(`/api/runs/{run}/${what}`, { run: this.run }, query));
      if (this.closed) return undefined;
      if (response.ok) return await response.arrayBuffer();
      this.trouble.value = `The run cannot be read (${response.status}).`;
    } catch {
      this.trouble.value = "The server cannot be reached.";
    }
    return undefined;
  }
}

/** An event as the API tells it. */
function eventOf(told: About["events"][number]): Event {
  const name = told.severity.replace("SEVERITY_", "") as keyof typeof Severity;
  return create(EventSchema, {
    stamp: {
      timeNs: BigInt(told.stamp?.time_ns ?? "0"),
      missionTimeS: told.stamp?.mission_time_s ?? 0,
      cycle: BigInt(told.stamp?.cycle ?? "0"),
    },
    severity: Severity[name],
    code: told.code,
    text: told.text,
    details: told.details,
  });
}
