// The last events, newest first, each once: a reconnect replays them.
import { signal } from "@preact/signals";
import type { Event } from "../gen/bumpless_pb";

const KEPT = 400;

function keyOf(event: Event): string {
  return `${event.stamp?.timeNs}/${event.code}/${event.text}`;
}

export class EventLog {
  readonly shown = signal<readonly Event[]>([]);
  private kept: Event[] = [];
  private seen = new Set<string>();
  private readonly received = new WeakMap<Event, bigint>();

  /** In the order in which the server received them: a vehicle's clock can step, or stand in 1970. */
  add(event: Event, receivedNs: bigint): void {
    const key = keyOf(event);
    if (this.seen.has(key)) return;
    this.seen.add(key);
    this.received.set(event, receivedNs);
    const place = this.kept.findIndex((other) => !this.isBefore(event, other));
    this.kept = this.kept.toSpliced(place < 0 ? this.kept.length : place, 0, event).slice(0, KEPT);
    if (this.seen.size > 4 * KEPT) this.seen = new Set(this.kept.map(keyOf));
  }

  private isBefore(one: Event, other: Event): boolean {
    const [a, b] = [this.received.get(one) ?? 0n, this.received.get(other) ?? 0n];
    return a === b ? (one.stamp?.timeNs ?? 0n) < (other.stamp?.timeNs ?? 0n) : a < b;
  }

  /** Make what was added visible. */
  show(): void {
    this.shown.value = this.kept;
  }
}
