// Pointer in space: take a point along, or go round the plan.
import { signal } from "@preact/signals";
import type { Gestures, Press } from "../map/surface";
import { grid } from "../map/tools";
import type { Size } from "../map/viewport";
import { type Ned, shifted, snapped } from "../model/geometry";
import { moveEdits, placeOf } from "../model/operations";
import { drag, drop, letGo, mission, selected } from "../model/plan";
import { around, Lens, nearer, type Orbit, slid, turned } from "./orbit";
import { placesOf, pointsOf } from "./scene";

const REACH_PX = 12;
const REACH_TOUCH_PX = 26;
const RAD_PER_PX = 0.006;
const DEPTH_STEP_M = 0.1;
const CLICK_PX = 4;

export const size = signal<Size>({ width: 0, height: 0 });
export const orbit = signal<Orbit>({
  at: [0, 0, 0],
  azimuth: -0.6,
  elevation: 0.5,
  distance: 40,
  stretch: 1,
});
export const hovered = signal<string | undefined>(undefined);

export function lens(): Lens {
  return new Lens(orbit.value, size.value);
}

export function showAll(): void {
  orbit.value = around(orbit.peek(), size.peek(), placesOf(mission.peek()));
}

type Doing =
  | { kind: "point"; thing: string; from: Ned; far: number; depth: boolean }
  | { kind: "turn" | "slide"; x: number; y: number };

let doing: Doing | undefined;
let from: Press | undefined;
let moved = false;

function pointAt(at: Press): { thing: string; at: Ned; far: number } | undefined {
  const now = new Lens(orbit.peek(), size.peek());
  const reach = at.touch ? REACH_TOUCH_PX : REACH_PX;
  let best: { thing: string; at: Ned; far: number } | undefined;
  let least = reach;
  for (const point of pointsOf(mission.peek())) {
    const seen = now.see(point.at);
    if (!seen) continue;
    const off = Math.hypot(seen[0] - at.x, seen[1] - at.y);
    if (off < least) [best, least] = [{ ...point, far: seen[2] }, off];
  }
  return best;
}

function pull(held: Doing & { kind: "point" }, at: Press, start: Press): void {
  const now = new Lens(orbit.peek(), size.peek());
  const by = held.depth ? dive(now, held, at.y - start.y, at.alt) : glide(now, held, at, start);
  if (!by) return;
  const chosen = selected.peek().includes(held.thing) ? selected.peek() : [held.thing];
  drag((view) => {
    const places = chosen.flatMap((thing) => {
      const place = placeOf(view, thing);
      return place ? [[thing, shifted(place, by)] as const] : [];
    });
    return moveEdits(view, new Map(places));
  });
}

/** Along the plane of its depth. */
function glide(now: Lens, held: Doing & { kind: "point" }, at: Press, start: Press): Ned | undefined {
  const [a, b] = [now.placeAt(start.x, start.y, held.from[2]), now.placeAt(at.x, at.y, held.from[2])];
  if (!a || !b) return undefined;
  const step = at.alt ? 0 : grid.peek();
  const to = (axis: 0 | 1): number => snapped(held.from[axis] + b[axis] - a[axis], step) - held.from[axis];
  return [to(0), to(1), 0];
}

function dive(now: Lens, held: Doing & { kind: "point" }, dy: number, fine: boolean): Ned {
  const to = held.from[2] + dy * now.depthPerPx(held.far);
  return [0, 0, snapped(Math.max(0, to), fine ? 0 : DEPTH_STEP_M) - held.from[2]];
}

export const gestures: Gestures = {
  press(at) {
    from = at;
    moved = false;
    const point = at.other ? undefined : pointAt(at);
    if (!point) {
      doing = { kind: at.other || at.many ? "slide" : "turn", x: at.x, y: at.y };
      return;
    }
    const now = selected.peek();
    if (!now.includes(point.thing))
      selected.value = at.many && !at.shift ? [...now, point.thing] : [point.thing];
    doing = { kind: "point", thing: point.thing, from: point.at, far: point.far, depth: at.shift };
  },
  move(at, pressed) {
    if (!pressed || !doing || !from) {
      const over = pointAt(at)?.thing;
      if (over !== hovered.peek()) hovered.value = over;
      return;
    }
    if (Math.hypot(at.x - from.x, at.y - from.y) > CLICK_PX) moved = true;
    if (!moved) return;
    if (doing.kind === "point") {
      pull(doing, at, from);
      return;
    }
    const [dx, dy] = [at.x - doing.x, at.y - doing.y];
    orbit.value =
      doing.kind === "turn"
        ? turned(orbit.peek(), -dx * RAD_PER_PX, dy * RAD_PER_PX)
        : slid(orbit.peek(), size.peek(), dx, dy);
    doing = { ...doing, x: at.x, y: at.y };
  },
  release(_at, cancelled) {
    const was = doing;
    doing = undefined;
    if (was?.kind === "point") {
      if (cancelled) letGo();
      else if (moved) drop(was.depth ? "Change the depth" : "Move");
    } else if (was && !moved && !cancelled) selected.value = [];
  },
  wheel: (_at, by) => {
    orbit.value = nearer(orbit.peek(), Math.exp(-by * 0.0015));
  },
  pinch: (_at, by, dx, dy) => {
    orbit.value = slid(nearer(orbit.peek(), by), size.peek(), dx, dy);
  },
  leave: () => {
    hovered.value = undefined;
  },
};
