// Pointer on the plan: what is pressed, dragged and let go.
import { signal } from "@preact/signals";
import { bearing, type Ned, snapped } from "../model/geometry";
import type { Outline, Point } from "../model/mission";
import {
  addWaypoint,
  defaultDepth,
  moveEdits,
  placeDock,
  placeOf,
  setCurrent,
  splitLeg,
  waveEdits,
} from "../model/operations";
import { drag, drop, letGo, mission, selected } from "../model/plan";
import { outlineAt, outlineThing, type Thing } from "../model/things";
import { inside, sideDistance, splitSide } from "../model/zones";
import { fitSoon, look, size, viewport } from "./camera";
import { currentAt, pulled, waveAt } from "./grip_drag";
import { DIAL, dialScale, type Grip, gripAt, gripsOf, WAVES, waveScale } from "./grips";
import { closeOutline, drawn, rectangle } from "./outline";
import type { Gestures, Press } from "./surface";
import { grid, measured, outlining, tool } from "./tools";
import { panned, toMetres, toPx, zoomed } from "./viewport";

export const hovered = signal<Grip | undefined>(undefined);
export const cursorAt = signal<readonly [north: number, east: number] | undefined>(undefined);
export const box = signal<readonly [number, number, number, number] | undefined>(undefined);

type Doing =
  | { kind: "grip"; grip: Grip; label: string }
  | { kind: "pan"; x: number; y: number }
  | { kind: "box" }
  | { kind: "dock"; at: Ned; heading: number | undefined }
  | { kind: "current" }
  | { kind: "wave" }
  | { kind: "outline"; at: Point; shown: Outline }
  | { kind: "shift"; thing: Thing; at: Point }
  | { kind: "click" };

let doing: Doing | undefined;
let from: Press | undefined;
let moved = false;
const CLICK_PX = 4;

const LABELS: Record<Grip["kind"], string> = {
  move: "Move",
  split: "Split a leg",
  "start-heading": "Turn the start",
  "dock-heading": "Turn the dock",
  standoff: "Change the standoff",
  current: "Change the current",
  side: "Add a corner",
  wave: "Change the waves",
};

function metres(at: Press): readonly [north: number, east: number] {
  const [e, n] = toMetres(viewport.peek(), size.peek(), at.x, at.y);
  return [n, e];
}

function place(at: Press): readonly [number, number] {
  const step = at.alt ? 0 : grid.peek();
  const [n, e] = metres(at);
  return [snapped(n, step), snapped(e, step)];
}

function grips(): Grip[] {
  return gripsOf(mission.peek(), viewport.peek(), size.peek(), selected.peek());
}

function choose(grip: Grip, many: boolean): void {
  const now = selected.peek();
  if (many) {
    selected.value = now.includes(grip.thing) ? now.filter((id) => id !== grip.thing) : [...now, grip.thing];
  } else if (!now.includes(grip.thing)) selected.value = [grip.thing];
}

function take(grip: Grip, at: Press): Doing {
  if (grip.kind === "split" && grip.leg !== undefined) {
    const [n, e] = place(at);
    const view = mission.peek();
    const before = view.legs[grip.leg - 1]?.at ?? view.start.at;
    const depth = ((view.legs[grip.leg]?.at[2] ?? before[2]) + before[2]) / 2;
    splitLeg(grip.leg, [n, e, depth]);
    return { kind: "grip", grip: { ...grip, kind: "move" }, label: LABELS.move };
  }
  if (grip.kind === "side" && grip.corner !== undefined) {
    const which = outlineAt(grip.thing);
    if (which !== undefined) splitSide(which, grip.corner, place(at));
    return {
      kind: "grip",
      grip: { ...grip, kind: "move", thing: selected.peek()[0] ?? "" },
      label: LABELS.move,
    };
  }
  choose(grip, at.many);
  return { kind: "grip", grip, label: LABELS[grip.kind] };
}

const SIDE_PX = 8;

/** The zone under a place, the last drawn on top; the boundary is taken hold of by its sides. */
function zoneAt(at: Press): Thing | undefined {
  const where = metres(at);
  const { keepIn, keepOut } = mission.peek();
  const side = (SIDE_PX * (at.touch ? 2 : 1)) / viewport.peek().sx;
  if (keepIn && sideDistance(keepIn, where) < side) return "fence";
  const index = keepOut.findLastIndex(({ corners }) => inside(corners, where));
  return index < 0 ? undefined : outlineThing(index);
}

function held(thing: Thing | undefined): boolean {
  return thing !== undefined && selected.peek().includes(thing);
}

const CLOSES_PX = 14;

/** Whether a place closes the outline that is being drawn. */
function closes(at: Press): boolean {
  const [first] = drawn.peek();
  if (!first || drawn.peek().length < 3) return false;
  const [x, y] = toPx(viewport.peek(), size.peek(), first[1], first[0]);
  return Math.hypot(at.x - x, at.y - y) < CLOSES_PX * (at.touch ? 2 : 1);
}

function press(at: Press): void {
  from = at;
  moved = false;
  if (at.other) {
    doing = { kind: "pan", x: at.x, y: at.y };
    return;
  }
  const grip = gripAt(grips(), at.x, at.y, at.touch);
  const hand = tool.peek();
  if (hand === "measure") doing = { kind: "click" };
  else if (outlining.peek()) doing = { kind: "outline", at: place(at), shown: drawn.peek() };
  else if (hand === "dock" && grip?.kind !== "dock-heading") {
    const [n, e] = place(at);
    const view = mission.peek();
    doing = { kind: "dock", at: [n, e, view.dock?.at[2] ?? defaultDepth(view)], heading: undefined };
  } else if (grip && (hand === "select" || grip.kind !== "split")) doing = take(grip, at);
  else if (hand === "current" || hand === "wave") doing = { kind: hand };
  else if (hand === "select" && held(zoneAt(at)))
    doing = { kind: "shift", thing: zoneAt(at) ?? "", at: metres(at) };
  else if (hand === "select" && at.shift) doing = { kind: "box" };
  else doing = { kind: "click" };
}

function move(at: Press, pressed: boolean): void {
  const [n, e] = metres(at);
  cursorAt.value = [n, e];
  if (!pressed || !doing || !from) {
    const over = gripAt(grips(), at.x, at.y, at.touch);
    if (over?.thing !== hovered.peek()?.thing || over?.kind !== hovered.peek()?.kind) hovered.value = over;
    return;
  }
  if (Math.hypot(at.x - from.x, at.y - from.y) > CLICK_PX) moved = true;
  if (!moved) return;
  const v = viewport.peek();
  switch (doing.kind) {
    case "grip": {
      const pull = {
        grip: doing.grip,
        to: [n, e] as const,
        px: [at.x, at.y] as const,
        grid: grid.peek(),
        fine: at.alt,
        selected: selected.peek(),
      };
      drag((view) => pulled(view, pull, v));
      break;
    }
    case "click":
      doing = { kind: "pan", x: from.x, y: from.y };
      break;
    case "pan":
      look(panned(v, size.peek(), at.x - doing.x, at.y - doing.y));
      doing = { kind: "pan", x: at.x, y: at.y };
      break;
    case "box":
      box.value = [from.x, from.y, at.x, at.y];
      break;
    case "outline":
      if (doing.shown.length === 0) box.value = [from.x, from.y, at.x, at.y];
      break;
    case "shift":
      shiftOutline(doing, [n, e], at.alt ? 0 : grid.peek());
      break;
    case "wave": {
      const px = [WAVES.x + at.x - from.x, WAVES.y + at.y - from.y] as const;
      const scale = waveScale(mission.peek().wave?.height ?? 0);
      drag((view) => waveEdits(view, waveAt(px, scale, v, at.alt)));
      break;
    }
    case "dock":
      doing.heading = snapped(bearing(doing.at, [n, e, 0]), at.alt ? 1 : 5) % 360;
      break;
    case "current": {
      const px = [DIAL.x + at.x - from.x, DIAL.y + at.y - from.y] as const;
      drag((view) => setCurrent(view, currentAt(px, dialScale(view.current), v, at.alt)));
      break;
    }
  }
}

/** Move a zone as a whole by as far as the pointer has gone. */
function shiftOutline({ thing, at }: { thing: Thing; at: Point }, to: Point, step: number): void {
  const by = [snapped(to[0] - at[0], step), snapped(to[1] - at[1], step)] as const;
  drag((view) => {
    const where = placeOf(view, thing);
    return where ? moveEdits(view, new Map([[thing, [where[0] + by[0], where[1] + by[1], where[2]]]])) : [];
  });
}

function release(at: Press, cancelled: boolean): void {
  const was = doing;
  doing = undefined;
  box.value = undefined;
  if (!was || !from) return;
  if (cancelled) {
    letGo();
    return;
  }
  if (was.kind === "grip") drop(was.label);
  else if (was.kind === "shift") {
    if (moved) drop("Move the zone");
  } else if (was.kind === "current" || was.kind === "wave") {
    drop(LABELS[was.kind]);
    if (!moved) return;
    selected.value = [was.kind];
    tool.value = "select";
  } else if (was.kind === "outline") cornered(was, at);
  else if (was.kind === "click" && !moved) clicked(at);
  else if (was.kind === "box" && moved) boxed(from, at);
  else if (was.kind === "dock") {
    placeDock(was.at, was.heading);
    fitSoon.value = true;
    tool.value = "select";
  }
}

/** One more corner, the last one, or a rectangle at once. */
function cornered(was: { at: Point; shown: Outline }, at: Press): void {
  if (moved && was.shown.length === 0) rectangle(was.at, place(at));
  else if (closes(at)) closeOutline();
  else drawn.value = [...was.shown, place(at)];
}

function clicked(at: Press): void {
  const [n, e] = place(at);
  if (tool.peek() === "waypoint") addWaypoint(n, e);
  else if (tool.peek() === "measure") measured.value = [...measured.peek(), [n, e]];
  else if (!at.many) {
    const zone = tool.peek() === "select" ? zoneAt(at) : undefined;
    selected.value = zone ? [zone] : [];
  }
}

function boxed(a: Press, b: Press): void {
  const inside = ([x, y]: readonly [number, number]): boolean =>
    x >= Math.min(a.x, b.x) && x <= Math.max(a.x, b.x) && y >= Math.min(a.y, b.y) && y <= Math.max(a.y, b.y);
  const view = mission.peek();
  const px = ([n, e]: Ned): readonly [number, number] => toPx(viewport.peek(), size.peek(), e, n);
  const found = view.legs.flatMap((leg, i) => (inside(px(leg.at)) ? [`leg:${i}`] : []));
  if (inside(px(view.start.at))) found.unshift("start");
  if (view.dock && inside(px(view.dock.at))) found.push("dock");
  selected.value = found;
}

export const gestures: Gestures = {
  press,
  move,
  release,
  wheel: (at, by) => look(zoomed(viewport.peek(), size.peek(), at.x, at.y, Math.exp(-by * 0.0015))),
  pinch: (at, by, dx, dy) =>
    look(panned(zoomed(viewport.peek(), size.peek(), at.x, at.y, by), size.peek(), dx, dy)),
  leave: () => {
    cursorAt.value = undefined;
    hovered.value = undefined;
  },
};
