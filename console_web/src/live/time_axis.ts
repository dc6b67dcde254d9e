// One time window for the mode strip and all plots: the last W seconds of vehicle time.
import { signal } from "@preact/signals";
import { room } from "../ahead/room";
import type { Mode } from "../gen/bumpless_pb";
import { clock } from "../lib/format";
import type { History } from "../stream/history";
import { heldAt, screen } from "../stream/screen";

export const WINDOWS_S = [5, 10, 30, 60, 120, 300, 600] as const;
export const window_s = signal<number>(120);
const SHORTEST_WINDOW_S = 1;

/** Hold the live plots where they are, while what comes is still taken in. */
export function hold(): void {
  if (screen.isLive && screen.history.length) heldAt.value = screen.until;
}

/** Back to the present. */
export function follow(): void {
  heldAt.value = Number.NaN;
}

/** Hold the right edge at a vehicle time, s; at the newest row or beyond, the present is followed. */
export function holdAt(time: number): void {
  if (!screen.isLive || !screen.history.length) return;
  const [first, last] = [screen.history.first(), screen.history.last()];
  if (time >= last) follow();
  else heldAt.value = Math.max(time, Math.min(last, first + SHORTEST_WINDOW_S));
}

/** Back (below 0) or forward by a share of the window. */
export function scrub(share: number): void {
  const [from, to] = shown();
  if (Number.isFinite(to)) holdAt(to + share * (to - from));
}

/** The next shorter (below 0) or longer window. */
export function zoom(by: -1 | 1): void {
  const now = window_s.peek();
  const next = by < 0 ? WINDOWS_S.findLast((s) => s < now) : WINDOWS_S.find((s) => s > now);
  if (next) window_s.value = next;
}

/** Show exactly this stretch. */
export function showStretch(from: number, to: number): void {
  if (!screen.isLive || to - from < SHORTEST_WINDOW_S / 4) return;
  window_s.value = Math.max(SHORTEST_WINDOW_S, to - from);
  holdAt(to);
}

/** A record younger than the window is shown from its beginning, but never less than this, s. */
const SHORTEST_S = 30;
/** From this age on a mission alone is shown, without the idle time before it, s. */
const SHORTEST_MISSION_S = 10;

/** The stretch of vehicle time that is shown now, s; [NaN, NaN] before the first value. */
export function shown(of?: History): [from: number, to: number] {
  const to = of ? of.last() : screen.until;
  const [from, until] = stretch(of ?? screen.history, to);
  return [from, of ? until : until + room()];
}

function stretch(of: History, to: number): [from: number, to: number] {
  const chosen = window_s.peek();
  const mission = to - of.missionStart;
  if (mission >= SHORTEST_MISSION_S && mission <= chosen) return [of.missionStart, to];
  return [Math.max(to - chosen, Math.min(of.first(), to - Math.min(SHORTEST_S, chosen))), to];
}

export interface Span {
  mode: Mode;
  start: number;
  end: number;
}

/** Stretches of one mode between two vehicle times, in order. */
export function spans(from: number, to: number, of: History = screen.history): Span[] {
  const found: Span[] = [];
  for (let i = of.firstIndex(from); i < of.length; i++) {
    const time = of.time[i] as number;
    if (time > to) break;
    const mode = of.mode[i] as Mode;
    const last = found.at(-1);
    if (last) last.end = time;
    if (!last || last.mode !== mode) found.push({ mode, start: time, end: time });
  }
  return found;
}

/** Times at whole steps of mission time, or counted back from `to` when no mission has been seen. */
export function ticks(from: number, to: number, step: number, of: History = screen.history): number[] {
  const origin = Number.isFinite(of.missionStart) ? of.missionStart : to;
  const times: number[] = [];
  for (let k = Math.ceil((from - origin) / step); origin + k * step <= to; k++) times.push(origin + k * step);
  return times;
}

/** Mission time when a mission has flown, else seconds before the newest value. */
export function timeLabel(time: number, newest: number, of: History = screen.history): string {
  if (Number.isFinite(of.missionStart)) return clock(Math.round((time - of.missionStart) * 10) / 10);
  return `${Math.round(time - newest)} s`.replace("-", "\u2212");
}
