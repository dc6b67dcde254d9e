// One condition of a switch as it is shown: what it is against its limit, and how near it is.
import type { Guard } from "../gen/bumpless_pb";
import { fixed } from "../lib/format";

/** How much of the way to being met, 0 to 1; a yes or no has no way. */
export function shareOf({ value, limit, atLeast, met }: Guard): number {
  if (met) return 1;
  if (!Number.isFinite(value) || !Number.isFinite(limit)) return 0;
  const share = atLeast ? value / (limit || 1) : (limit || 1) / Math.max(value, 1e-9);
  return Math.max(0, Math.min(1, share));
}

const isYesNo = (guard: Guard): boolean => guard.limit === 1 && guard.atLeast && guard.unit === "";

/** "range 0.82 > 0.60 m", "dwell 1.2 of 3.0 s", "seen in 5 frames: 3 of 3". */
export function wordsOf(guard: Guard): string {
  const { name, value, limit, atLeast, met, unit } = guard;
  const count = unit === "" && Number.isInteger(value) && Number.isInteger(limit);
  if (isYesNo(guard) && count && limit === 1 && value <= 1) return met ? name : `${name}: not yet`;
  const places = count ? 0 : unit === "°" || unit === "s" ? 1 : 2;
  const end = unit ? (unit === "°" ? unit : ` ${unit}`) : "";
  if (atLeast && (unit === "s" || count)) {
    return `${name}${count ? ":" : ""} ${fixed(value, places)} of ${fixed(limit, places)}${end}`;
  }
  const sign = atLeast ? (met ? "≥" : "<") : met ? "≤" : ">";
  return `${name} ${fixed(value, places)} ${sign} ${fixed(limit, places)}${end}`;
}

/** "in about 4 s"; nothing where nobody can tell. */
export function whenWords(seconds: number): string {
  if (!Number.isFinite(seconds) || seconds > 600) return "";
  return seconds < 0.5 ? "now" : `in about ${fixed(seconds, 0)} s`;
}
