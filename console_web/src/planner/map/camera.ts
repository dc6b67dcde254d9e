// Where the plan is looked at from.
import { computed, signal } from "@preact/signals";
import { plan } from "../fly/forecast";
import { along, type Ned } from "../model/geometry";
import { mission } from "../model/plan";
import { dockUp } from "./tools";
import { fitted, panned, type Size, type Viewport } from "./viewport";

export const size = signal<Size>({ width: 0, height: 0 });
const MARGIN = 84; // px, less on a low picture: room for the rings round the dock
const HEAD_PX = 44; // for the line that says what to do next
const LEAST_M = 16;
const ROOM_M = 40; // ahead of a vehicle without a way

const unturned = signal<Viewport>({ x: 0, y: 8, sx: 18, sy: 18, turn: 0 });
const turnOf = (): number =>
  dockUp.value && mission.value.dock ? (mission.value.dock.heading * Math.PI) / 180 : 0;
export const viewport = computed<Viewport>(() => ({ ...unturned.value, turn: turnOf() }));

/** The next forecast shall be in view as a whole: a plan was opened, a dock placed, a finding mended. */
export const fitSoon = signal(true);

/** What the whole plan in view was like: kept whole when the picture's size changes. */
let whole: Viewport | undefined;

/** The picture has another size. */
export function sized(next: Size): void {
  size.value = next;
  if (whole !== undefined && whole === unturned.peek()) showAll();
}

export function look(next: Viewport): void {
  unturned.value = next;
}

/** The whole plan, and what is foreseen of it, in view. */
export function showAll(): void {
  const view = mission.peek();
  const points: Ned[] = [view.start.at, ...view.legs.map((leg) => leg.at)];
  if (view.dock) points.push(view.dock.at);
  if (view.legs.length === 0) {
    points.push(along(view.start.at, view.start.heading, ROOM_M));
    points.push(along(view.start.at, view.start.heading + 180, ROOM_M / 8));
  }
  const track = plan.current.peek() ? plan.forecast.peek()?.nominal?.track : undefined;
  const flown = track?.north_m.map((n, i) => [track.east_m[i] ?? 0, n] as const) ?? [];
  const shown = [...points.map(([n, e]) => [e, n] as const), ...flown];
  const { width, height } = size.peek();
  const below = { width, height: height - HEAD_PX };
  const all = fitted(shown, below, Math.min(MARGIN, 0.16 * height), viewport.peek().turn, [LEAST_M, LEAST_M]);
  whole = panned(all, size.peek(), 0, HEAD_PX / 2);
  unturned.value = whole;
}
