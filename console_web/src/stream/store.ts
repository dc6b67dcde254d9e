// The newest message of each topic, with its age. The age counts from the moment the server
// received the message, so a value replayed to a late joiner is not taken for a live one.
import { fromBinary } from "@bufbuild/protobuf";
import { EventSchema, StreamFrameSchema, type Event } from "../gen/bumpless_pb";
import { invalidate } from "./frame";
import { isTopic, TOPICS, type MessageOf, type TopicName } from "./topics";

interface Sample {
  message: unknown;
  /** performance.now() minus the age at arrival, ms. */
  born: number;
}

/** `past`: the frame is from before this connection, now and then a cycle, for the plots. */
type Listener = (changed: ReadonlySet<TopicName>, past: boolean) => void;

export type Connection = "connecting" | "open" | "lost";

const EVENTS_KEPT = 400;

export class LiveStore {
  connection: Connection = "connecting";
  /** performance.now() of the last frame, ms; 0 before the first. */
  lastFrame = 0;
  /** performance.now() when the connection was lost, ms. */
  lostAt = 0;
  /** performance.now() of the next attempt, ms. */
  retryAt = 0;
  /** Newest first. */
  events: Event[] = [];
  private readonly seen = new Set<string>();
  private readonly samples = new Map<TopicName, Sample>();
  private readonly listeners = new Set<Listener>();

  latest<K extends TopicName>(name: K): MessageOf<K> | undefined {
    return this.samples.get(name)?.message as MessageOf<K> | undefined;
  }

  /** Seconds since the server received the newest message; undefined when there is none. */
  age(name: TopicName): number | undefined {
    const sample = this.samples.get(name);
    return sample && Math.max(0, (performance.now() - sample.born) / 1000);
  }

  isFresh(name: TopicName): boolean {
    const age = this.age(name);
    return this.connection === "open" && age !== undefined && age <= TOPICS[name].freshFor;
  }

  /** Called once per received frame with the topics that changed. */
  onChange(listener: Listener): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  receive(bytes: Uint8Array): void {
    const frame = fromBinary(StreamFrameSchema, bytes);
    const now = performance.now();
    this.lastFrame = now;
    const changed = new Set<TopicName>();
    for (const { topic, payload, receiveTimeNs } of frame.messages) {
      if (isTopic(topic)) {
        const message = fromBinary(TOPICS[topic].schema as never, payload);
        const ageMs = receiveTimeNs ? Number(frame.serverTimeNs - receiveTimeNs) / 1e6 : 0;
        this.samples.set(topic, { message, born: now - Math.max(0, ageMs) });
        changed.add(topic);
      } else if (topic === "event" || topic.endsWith("/event")) {
        this.addEvent(fromBinary(EventSchema, payload));
      }
    }
    for (const listener of this.listeners) listener(changed, frame.past);
    invalidate();
  }

  /** A reconnect replays events: each is kept once. */
  private addEvent(event: Event): void {
    const key = keyOf(event);
    if (this.seen.has(key)) return;
    this.seen.add(key);
    const at = event.stamp?.timeNs ?? 0n;
    const place = this.events.findIndex((other) => (other.stamp?.timeNs ?? 0n) <= at);
    this.events = this.events.toSpliced(place < 0 ? this.events.length : place, 0, event).slice(0, EVENTS_KEPT);
    if (this.seen.size > 4 * EVENTS_KEPT) {
      this.seen.clear();
      for (const kept of this.events) this.seen.add(keyOf(kept));
    }
  }
}

function keyOf(event: Event): string {
  return `${event.stamp?.timeNs}/${event.code}/${event.text}`;
}

export const live = new LiveStore();
