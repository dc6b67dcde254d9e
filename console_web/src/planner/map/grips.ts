// What can be taken hold of on the plan, nearest first.
import { along, type Ned, observationPoint } from "../model/geometry";
import type { MissionView, Wave } from "../model/mission";
import { cornersOf, cornerThing, outlineAt, outlineThing, type Which } from "../model/things";
import { type Size, toPx, type Viewport } from "./viewport";

export type GripKind =
  | "move"
  | "start-heading"
  | "dock-heading"
  | "standoff"
  | "split"
  | "side"
  | "current"
  | "wave";
export interface Grip {
  kind: GripKind;
  /** The thing that is selected with it. */
  thing: string;
  px: readonly [number, number];
  /** Reach, px. */
  reach: number;
  leg?: number;
  /** Corner of an outline before which the side would be broken. */
  corner?: number;
}

const REACH = 11;
const ARM = 46; // px from a thing to its heading handle
/** A dial, px: its place from the corner and its radius. */
export interface Dial {
  x: number;
  y: number;
  radius: number;
}
/** The current's, and below it the one of the waves. */
export const DIAL: Dial = { x: 62, y: 66, radius: 42 };
export const WAVES: Dial = { x: 62, y: 206, radius: 42 };
const SCALES = [0.25, 0.5, 1, 2, 5]; // what the radius stands for: m/s
const HEIGHTS = [0.5, 1, 2, 5, 20]; // m

export function dialScale(current: Ned): number {
  const speed = Math.hypot(current[0], current[1]);
  return SCALES.find((most) => speed <= most * 0.9) ?? 5;
}

export function dialTip(current: Ned, v: Viewport): readonly [number, number] {
  const k = DIAL.radius / dialScale(current);
  const [c, s] = [Math.cos(v.turn), Math.sin(v.turn)];
  const [n, e] = current;
  return [DIAL.x + (c * e - s * n) * k, DIAL.y - (s * e + c * n) * k];
}

export function waveScale(height: number): number {
  return HEIGHTS.find((most) => height <= most * 0.9) ?? 20;
}

export function waveTip({ height, direction }: Wave, v: Viewport): readonly [number, number] {
  const k = (WAVES.radius * height) / waveScale(height);
  const way = (direction * Math.PI) / 180 - v.turn;
  return [WAVES.x + k * Math.sin(way), WAVES.y - k * Math.cos(way)];
}

/** Metres of a handle's arm at this scale. */
export function arm(v: Viewport): number {
  return ARM / v.sx;
}

export function gripsOf(view: MissionView, v: Viewport, size: Size, selected: readonly string[]): Grip[] {
  const at = ([n, e]: Ned): readonly [number, number] => toPx(v, size, e, n);
  const grips: Grip[] = [{ kind: "current", thing: "current", px: dialTip(view.current, v), reach: 14 }];
  const { dock, start } = view;
  if (view.wave) grips.push({ kind: "wave", thing: "wave", px: waveTip(view.wave, v), reach: 14 });
  for (const which of new Set(selected.flatMap((thing) => outlineAt(thing) ?? [])))
    grips.push(...outlineGrips(view, which, at));
  if (dock) {
    const turned = at(along(dock.at, dock.heading, arm(v)));
    grips.push({ kind: "dock-heading", thing: "dock", px: turned, reach: REACH });
    grips.push({ kind: "move", thing: "dock", px: at(dock.at), reach: REACH + 2 });
  }
  if (selected.includes("start"))
    grips.push({
      kind: "start-heading",
      thing: "start",
      px: at(along(start.at, start.heading, arm(v))),
      reach: REACH,
    });
  if (dock && selected.includes("dock")) {
    const px = at(observationPoint(dock.at, dock.heading, dock.standoff));
    grips.push({ kind: "standoff", thing: "dock", px, reach: REACH });
  }
  for (let i = view.legs.length - 1; i >= 0; i--) {
    const leg = view.legs[i];
    if (leg) grips.push({ kind: "move", thing: `leg:${i}`, px: at(leg.at), reach: REACH, leg: i });
  }
  grips.push({ kind: "move", thing: "start", px: at(start.at), reach: REACH });
  let from = at(start.at);
  view.legs.forEach((leg, i) => {
    const to = at(leg.at);
    if (Math.hypot(to[0] - from[0], to[1] - from[1]) > 60)
      grips.push({
        kind: "split",
        thing: `leg:${i}`,
        px: [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2],
        reach: 8,
        leg: i,
      });
    from = to;
  });
  return grips;
}

/** Corners to drag and sides to break, of an outline that is selected. */
function outlineGrips(
  view: MissionView,
  which: Which,
  at: (place: Ned) => readonly [number, number],
): Grip[] {
  const corners = (cornersOf(view, which) ?? []).map(([n, e]) => at([n, e, 0]));
  return corners.flatMap((px, corner): Grip[] => {
    const before = corners.at(corner - 1) ?? px;
    const own: Grip = { kind: "move", thing: cornerThing(which, corner), px, reach: REACH };
    if (Math.hypot(px[0] - before[0], px[1] - before[1]) < 50) return [own];
    const half = [(px[0] + before[0]) / 2, (px[1] + before[1]) / 2] as const;
    return [own, { kind: "side", thing: outlineThing(which), px: half, reach: 8, corner }];
  });
}

export function gripAt(grips: readonly Grip[], px: number, py: number, touch: boolean): Grip | undefined {
  const more = touch ? 12 : 0;
  let best: Grip | undefined;
  let least = 1;
  for (const grip of grips) {
    const share = Math.hypot(grip.px[0] - px, grip.px[1] - py) / (grip.reach + more);
    if (share < least) [best, least] = [grip, share];
  }
  return best;
}
