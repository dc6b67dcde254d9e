// One time window for the mode strip and all plots: the last W seconds of vehicle time.
import type { Mode } from "../gen/bumpless_pb";
import { clock } from "../lib/format";
import { history } from "../stream/log";
import { invalidate } from "../stream/frame";

export const WINDOWS_S = [30, 60, 120, 300, 600] as const;
let chosen: number = 120;

export function window_s(): number {
  return chosen;
}

/** A record younger than the window is shown from its beginning, but never less than this, s. */
const SHORTEST_S = 30;
/** From this age on a mission alone is shown, without the idle time before it, s. */
const SHORTEST_MISSION_S = 10;

/** The stretch of vehicle time that is shown now, s; [NaN, NaN] before the first value. */
export function shown(): [from: number, to: number] {
  const to = history.last();
  const first = history.time[0] ?? to;
  const mission = to - history.missionStart;
  if (mission >= SHORTEST_MISSION_S && mission <= chosen) return [history.missionStart, to];
  return [Math.max(to - chosen, Math.min(first, to - Math.min(SHORTEST_S, chosen))), to];
}

export function setWindow(seconds: number): void {
  chosen = seconds;
  invalidate();
}

/** Index of the first row at or after `time`, s. */
export function firstIndex(time: number): number {
  let low = 0;
  let high = history.time.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((history.time[middle] as number) < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

export interface Span {
  mode: Mode;
  start: number;
  end: number;
}

/** Stretches of one mode between two vehicle times, in order. */
export function spans(from: number, to: number): Span[] {
  const found: Span[] = [];
  for (let i = firstIndex(from); i < history.time.length; i++) {
    const time = history.time[i] as number;
    if (time > to) break;
    const mode = history.mode[i] as Mode;
    const last = found.at(-1);
    if (last) last.end = time;
    if (!last || last.mode !== mode) found.push({ mode, start: time, end: time });
  }
  return found;
}

/** Mission time when a mission has flown, else seconds before the newest value. */
export function timeLabel(time: number, newest: number): string {
  if (Number.isFinite(history.missionStart)) return clock(Math.round((time - history.missionStart) * 10) / 10);
  return `${Math.round(time - newest)} s`.replace("-", "\u2212");
}
