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

  add(event: Event): void {
    const key = keyOf(event);
    if (this.seen.has(key)) return;
    this.seen.add(key);
    const at = event.stamp?.timeNs ?? 0n;
    const place = this.kept.findIndex((other) => (other.stamp?.timeNs ?? 0n) <= at);
    this.kept = this.kept.toSpliced(place < 0 ? this.kept.length : place, 0, event).slice(0, KEPT);
    if (this.seen.size > 4 * KEPT) this.seen = new Set(this.kept.map(keyOf));
  }

  /** Make what was added visible. */
  show(): void {
    this.shown.value = this.kept;
  }
}
