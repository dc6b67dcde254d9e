// The newest message of each topic, with its age, as signals. Frames are decoded as they come and shown
// in an animation frame about seven times a second: a page that is not seen takes in everything and draws nothing.
// An age counts from the moment the server received the message, so a value replayed to a late joiner is
// not taken for a live one.
import { fromBinary } from "@bufbuild/protobuf";
import { batch, computed, type ReadonlySignal, type Signal, signal } from "@preact/signals";
import { type Event, EventSchema, StreamFrameSchema } from "../gen/bumpless_pb";
import { FRESH_FOR_S } from "../gen/house";
import { SCHEMAS } from "../gen/topics";
import { EventLog } from "./event_log";
import { pictures } from "./pictures";
import { isTopic, type MessageOf, type TopicName } from "./topics";

interface Sample {
  message: unknown;
  /** performance.now() minus the age at arrival, ms. */
  born: number;
}

interface Topic {
  shown: Signal<Sample | undefined>;
  fresh: ReadonlySignal<boolean>;
}

/** `past`: the frame is from before this connection, now and then a cycle, for the plots. */
type Listener = (changed: ReadonlySet<TopicName>, past: boolean) => void;

export type Connection = "connecting" | "open" | "lost";

const AGE_TICK_MS = 250;

export class LiveStore {
  readonly connection = signal<Connection>("connecting");
  /** performance.now() of what is shown, ms: ages are taken from it. */
  readonly now = signal(performance.now());
  /** performance.now() of the last frame, ms; 0 before the first. */
  lastFrame = 0;
  /** performance.now() when the connection was lost and of the next attempt, ms. */
  lostAt = 0;
  retryAt = 0;
  private readonly log = new EventLog();
  private readonly topics: Record<TopicName, Topic>;
  private readonly waiting = new Map<TopicName, Sample>();
  private readonly listeners = new Set<Listener>();
  private state: Connection = "connecting";
  private asked = false;

  constructor(private readonly inNextFrame: (run: () => void) => void = pictures()) {
    const names = Object.keys(SCHEMAS) as TopicName[];
    this.topics = Object.fromEntries(names.map((name) => [name, this.topic(name)])) as Record<
      TopicName,
      Topic
    >;
  }

  private topic(name: TopicName): Topic {
    const shown = signal<Sample | undefined>(undefined);
    const fresh = computed(() => {
      const age = this.ageOf(shown.value);
      return this.connection.value === "open" && age !== undefined && age <= FRESH_FOR_S[name];
    });
    return { shown, fresh };
  }

  private ageOf(sample: Sample | undefined): number | undefined {
    return sample && Math.max(0, (this.now.value - sample.born) / 1000);
  }

  /** The newest message that is shown. */
  latest<K extends TopicName>(name: K): MessageOf<K> | undefined {
    return this.topics[name].shown.value?.message as MessageOf<K> | undefined;
  }

  /** The newest message that has come, shown or not yet. */
  received<K extends TopicName>(name: K): MessageOf<K> | undefined {
    const sample = this.waiting.get(name) ?? this.topics[name].shown.peek();
    return sample?.message as MessageOf<K> | undefined;
  }

  /** Seconds since the server received the newest message; undefined when there is none. */
  age(name: TopicName): number | undefined {
    return this.ageOf(this.topics[name].shown.value);
  }

  isFresh(name: TopicName): boolean {
    return this.topics[name].fresh.value;
  }

  /** Nothing at all has come for longer than the server's own word is good for. */
  get silent(): boolean {
    return this.now.value - this.lastFrame > 1000 * FRESH_FOR_S["server/status"];
  }

  /** Newest first. */
  get events(): readonly Event[] {
    return this.log.shown.value;
  }

  /** Called once per received frame with the topics that changed, seen page or not. */
  onReceive(listener: Listener): () => void {
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
        const message = fromBinary(SCHEMAS[topic] as never, payload);
        const ageMs = receiveTimeNs ? Number(frame.serverTimeNs - receiveTimeNs) / 1e6 : 0;
        this.waiting.set(topic, { message, born: now - Math.max(0, ageMs) });
        changed.add(topic);
      } else if (topic === "event" || topic.endsWith("/event")) {
        this.log.add(fromBinary(EventSchema, payload), receiveTimeNs);
      }
    }
    for (const listener of this.listeners) listener(changed, frame.past);
    this.state = "open";
    this.showSoon();
  }

  /** The connection ended; the next attempt is `retryMs` away. */
  lose(retryMs: number): void {
    const now = performance.now();
    if (this.state !== "lost") this.lostAt = now;
    this.retryAt = now + retryMs;
    this.state = "lost";
    this.showSoon();
  }

  /** Ages go on while nothing comes. */
  keepTime(): void {
    setInterval(() => this.showSoon(), AGE_TICK_MS);
  }

  private showSoon(): void {
    if (this.asked) return;
    this.asked = true;
    this.inNextFrame(() => this.show());
  }

  private show(): void {
    this.asked = false;
    batch(() => {
      this.connection.value = this.state;
      for (const [name, sample] of this.waiting) this.topics[name].shown.value = sample;
      this.waiting.clear();
      this.log.show();
      this.now.value = performance.now();
    });
  }
}

export const live = new LiveStore();
