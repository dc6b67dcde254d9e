// What dragging a grip does to the plan.

import type { Edit } from "../model/document";
import { bearing, type Ned, shifted, snapped } from "../model/geometry";
import type { MissionView } from "../model/mission";
import { dockEdits, moveEdits, placeOf, setCurrent, waveEdits } from "../model/operations";
import { DIAL, type Dial, dialScale, type Grip, WAVES, waveScale } from "./grips";
import type { Viewport } from "./viewport";

export interface Pull {
  grip: Grip;
  /** Where it is pulled to, NED in the plane, and the same in pixels. */
  to: readonly [north: number, east: number];
  px: readonly [number, number];
  /** Metres of the grid, 0 for none. */
  grid: number;
  fine: boolean;
  selected: readonly string[];
}

const HEADING_STEP = 5;
const CURRENT_STEP = 0.01;
const WAVE_STEP = 0.05;

export function pulled(view: MissionView, pull: Pull, v: Viewport): readonly Edit[] {
  switch (pull.grip.kind) {
    case "move":
    case "split":
    case "side":
      return moveThings(view, pull);
    case "start-heading": {
      const value = heading(view.start.at, pull);
      return [{ path: ["start", "heading_deg"], value }];
    }
    case "dock-heading":
      return view.dock ? dockEdits(view, { heading: heading(view.dock.at, pull) }) : [];
    case "standoff":
      return standoff(view, pull);
    case "wave":
      return waveEdits(view, waveAt(pull.px, waveScale(view.wave?.height ?? 0), v, pull.fine));
    case "current":
      return setCurrent(view, currentAt(pull.px, dialScale(view.current), v, pull.fine));
  }
}

function heading(from: Ned, { to, fine }: Pull): number {
  const raw = bearing(from, [to[0], to[1], from[2]]);
  return snapped(raw, fine ? 1 : HEADING_STEP) % 360;
}

function moveThings(view: MissionView, { grip, to, grid, fine, selected }: Pull): Edit[] {
  const from = placeOf(view, grip.thing);
  if (!from) return [];
  const step = fine ? 0 : grid;
  const by: Ned = [snapped(to[0], step) - from[0], snapped(to[1], step) - from[1], 0];
  const things = selected.includes(grip.thing) ? selected : [grip.thing];
  const places = things.flatMap((thing) => {
    const place = placeOf(view, thing);
    return place ? [[thing, shifted(place, by)] as const] : [];
  });
  return moveEdits(view, new Map(places));
}

function standoff(view: MissionView, { to, fine }: Pull): Edit[] {
  if (!view.dock) return [];
  const rad = (view.dock.heading * Math.PI) / 180;
  const back = -((to[0] - view.dock.at[0]) * Math.cos(rad) + (to[1] - view.dock.at[1]) * Math.sin(rad));
  return dockEdits(view, { standoff: Math.max(0.1, snapped(back, fine ? 0.01 : 0.1)) });
}

/** The current that the dial shows with its arrow's tip at a pixel. */
export function currentAt(px: readonly [number, number], scale: number, v: Viewport, fine: boolean): Ned {
  const { size, way } = dialAt(DIAL, px, v, fine);
  const speed = snapped(size * scale, fine ? 0.001 : CURRENT_STEP);
  if (speed === 0) return [0, 0, 0];
  const rad = (way * Math.PI) / 180;
  return [speed * Math.cos(rad), speed * Math.sin(rad), 0];
}

/** The waves that their dial shows with its arrow's tip at a pixel. */
export function waveAt(
  px: readonly [number, number],
  scale: number,
  v: Viewport,
  fine: boolean,
): { height: number; direction: number } {
  const { size, way } = dialAt(WAVES, px, v, fine);
  return { height: snapped(size * scale, fine ? 0.01 : WAVE_STEP), direction: way };
}

/** Length of a dial's arrow as a share of its radius, and its heading. */
function dialAt(
  { x, y, radius }: Dial,
  px: readonly [number, number],
  v: Viewport,
  fine: boolean,
): { size: number; way: number } {
  const [a, b] = [px[0] - x, y - px[1]];
  const long = Math.hypot(a, b);
  // Near the rim the arrow reaches on, so that more can be drawn than the dial is wide.
  const size = long < 4 ? 0 : Math.min(long, 2 * radius) / radius;
  return { size, way: snapped((Math.atan2(a, b) + v.turn) * (180 / Math.PI), fine ? 1 : HEADING_STEP) };
}
