// Numbers as an operator reads them: fixed decimals, a true minus sign, a dash for nothing.

import { day, timeOfDay, type Zone, zone, zoneName } from "./zone";

export const NONE = "–";

export function fixed(value: number | null | undefined, decimals: number): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return NONE;
  const shown = value.toFixed(decimals);
  return Number(shown) === 0 ? shown.replace("-", "") : shown.replace("-", "\u2212");
}

/** With an explicit sign. */
export function signed(value: number | null | undefined, decimals: number): string {
  const shown = fixed(value, decimals);
  return value && value > 0 && Number(shown) > 0 ? `+${shown}` : shown;
}

/** A heading from 0 up to, but never showing, 360. */
export function headingOf(degrees: number | null | undefined, decimals: number): string {
  if (degrees === null || degrees === undefined) return NONE;
  const rounded = Number((((degrees % 360) + 360) % 360).toFixed(decimals));
  return fixed(rounded === 360 ? 0 : rounded, decimals);
}

/** Small and large numbers in few characters: 0.0123, 12.3, 1.2e-6. */
export function compact(value: number | null | undefined, digits = 3): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return NONE;
  if (value === 0) return "0";
  const size = Math.abs(value);
  const shown =
    size >= 1e-3 && size < 1e5 ? Number(value.toPrecision(digits)).toString() : value.toExponential(1);
  return shown.replace(/-/g, "\u2212");
}

/** m:ss, or h:mm:ss. */
export function clock(seconds: number | null | undefined): string {
  if (seconds === null || seconds === undefined || !Number.isFinite(seconds)) return NONE;
  const whole = Math.floor(Math.abs(seconds));
  const sign = seconds < 0 && whole > 0 ? "\u2212" : "";
  const two = (n: number): string => String(n).padStart(2, "0");
  const hours = Math.floor(whole / 3600);
  const rest = `${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
  return sign + (hours ? `${hours}:${rest}` : rest);
}

export function bytes(count: number | bigint | null | undefined): string {
  const value = Number(count ?? NaN);
  if (!Number.isFinite(value)) return NONE;
  if (value < 1000) return `${value} B`;
  if (value < 1e6) return `${(value / 1e3).toFixed(0)} kB`;
  return value < 1e9 ? `${(value / 1e6).toFixed(1)} MB` : `${(value / 1e9).toFixed(2)} GB`;
}

export function age(seconds: number | undefined): string {
  if (seconds === undefined) return "no data";
  return seconds < 100 ? `${seconds.toFixed(1)} s` : clock(seconds);
}

/** Date, time and zone of an ISO string or UNIX seconds. */
export function dateTime(value: string | number | undefined, of: Zone = zone.value): string {
  if (value === undefined || value === "") return NONE;
  const date = new Date(typeof value === "number" ? value * 1000 : value);
  if (Number.isNaN(date.getTime())) return String(value);
  return `${day(date, of)} ${timeOfDay(date, of)} ${zoneName(date, of)}`;
}

/** Decimals that tell multiples of a step apart and round none of them: 3 for 0.025. */
export function placesOf(step: number): number {
  const whole = (scaled: number): boolean => Math.abs(scaled - Math.round(scaled)) < 1e-6;
  return [0, 1, 2].find((places) => whole(step * 10 ** places)) ?? 3;
}
