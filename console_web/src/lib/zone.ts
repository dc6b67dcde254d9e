// Times of day are told with their zone: UTC until the operator chooses the local one.
import { signal } from "@preact/signals";

export type Zone = "UTC" | "local";
const KEY = "bumpless.zone";

function kept(): Zone {
  try {
    return localStorage.getItem(KEY) === "local" ? "local" : "UTC";
  } catch {
    return "UTC";
  }
}

export const zone = signal<Zone>(kept());

export function setZone(next: Zone): void {
  zone.value = next;
  try {
    localStorage.setItem(KEY, next);
  } catch {
    // Without storage the choice lasts as long as the page.
  }
}

const two = (n: number): string => String(n).padStart(2, "0");

/** "UTC", or the offset of the local zone on that day: "UTC+02:00". */
export function zoneName(date: Date, of: Zone = zone.value): string {
  const minutes = of === "UTC" ? 0 : -date.getTimezoneOffset();
  if (minutes === 0) return "UTC";
  const size = Math.abs(minutes);
  return `UTC${minutes < 0 ? "\u2212" : "+"}${two(Math.floor(size / 60))}:${two(size % 60)}`;
}

export function timeOfDay(date: Date, of: Zone = zone.value): string {
  const parts =
    of === "UTC"
      ? [date.getUTCHours(), date.getUTCMinutes(), date.getUTCSeconds()]
      : [date.getHours(), date.getMinutes(), date.getSeconds()];
  return parts.map(two).join(":");
}

export function day(date: Date, of: Zone = zone.value): string {
  return of === "UTC"
    ? `${date.getUTCFullYear()}-${two(date.getUTCMonth() + 1)}-${two(date.getUTCDate())}`
    : `${date.getFullYear()}-${two(date.getMonth() + 1)}-${two(date.getDate())}`;
}
