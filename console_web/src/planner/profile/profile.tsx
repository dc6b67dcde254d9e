// The depth profile: points are dragged up and down, the rest is shown.
import { signal } from "@preact/signals";
import { fixed } from "../../lib/format";
import { plan } from "../fly/forecast";
import { onPlanKey } from "../keys";
import { type Gestures, Surface } from "../map/surface";
import { type Size, toMetres, toPx, type Viewport } from "../map/viewport";
import type { Ned } from "../model/geometry";
import { snapped } from "../model/geometry";
import { valueAt } from "../model/mission";
import { moveEdits, placeOf } from "../model/operations";
import { drag, dragging, drop, letGo, mission, selected } from "../model/plan";
import { FOOT_PX, type Knot, knots, type ProfileScene, paintProfile, wayOf } from "./paint";
import "./profile.css";

const size = signal<Size>({ width: 0, height: 0 });
/** Scales hold still while something is dragged. */
let kept: Viewport | undefined;
const LEFT_PX = 54;
const STEP_M = 0.1;

function bottom(): number {
  const depth = valueAt(mission.value.raw, ["environment", "water_depth_m"]);
  return typeof depth === "number" ? depth : 0;
}

/** So much of the floor that it stands below the way, not all of a deep sea. */
function shown(ground: readonly (number | null)[]): number[] {
  const known = ground.filter((depth) => depth !== null);
  const view = mission.value;
  const deepest = Math.max(1, ...knots(view).map(({ depth }) => depth));
  return known.map((depth) => Math.min(depth, 3 * deepest + 5));
}

function viewportOf(extent: Size): Viewport {
  if (dragging.value && kept) return kept;
  const view = mission.value;
  const points = knots(view);
  const track = plan.current.value ? plan.forecast.value?.nominal?.track : undefined;
  const way = track ? wayOf(track.north_m, track.east_m) : [];
  const longest = Math.max(8, ...points.map((p) => p.along), way.at(-1) ?? 0);
  const ground = (plan.current.value ? plan.forecast.value?.floor?.floor_m : undefined) ?? [];
  const deepest =
    Math.max(1, ...points.map((p) => p.depth), ...(track?.depth_m ?? []), ...shown(ground)) * 1.18;
  const [w, h] = [Math.max(40, extent.width - LEFT_PX - 16), Math.max(30, extent.height - FOOT_PX - 14)];
  const [sx, sy] = [w / longest, h / deepest];
  // Zero depth 14 px below the top, zero distance LEFT_PX from the left.
  kept = { x: (extent.width / 2 - LEFT_PX) / sx, y: -(extent.height / 2 - 14) / sy, sx, sy, turn: 0 };
  return kept;
}

function scene(extent: Size): ProfileScene {
  const forecast = plan.forecast.value;
  const seed = plan.picked.value;
  return {
    view: mission.value,
    size: extent,
    viewport: viewportOf(extent),
    selected: selected.value,
    nominal: forecast?.nominal,
    picked: seed === undefined ? undefined : forecast?.flights.find((flight) => flight.seed === seed),
    stale: !plan.current.value || dragging.value,
    bottom: bottom(),
    floor: forecast?.floor,
  };
}

let taken: Knot | undefined;
let moved = false;

function knotAt(x: number, y: number, reach: number): Knot | undefined {
  const v = kept;
  if (!v) return undefined;
  return knots(mission.peek())
    .map((knot) => ({ knot, px: toPx(v, size.peek(), knot.along, -knot.depth) }))
    .map(({ knot, px }) => ({ knot, far: Math.hypot(px[0] - x, px[1] - y) }))
    .filter(({ far }) => far < reach)
    .sort((a, b) => a.far - b.far)[0]?.knot;
}

const gestures: Gestures = {
  press(at) {
    taken = knotAt(at.x, at.y, at.touch ? 26 : 13);
    moved = false;
    if (!taken) {
      if (!at.many) selected.value = [];
      return;
    }
    const { thing } = taken;
    const now = selected.peek();
    if (at.many) selected.value = now.includes(thing) ? now.filter((id) => id !== thing) : [...now, thing];
    else if (!now.includes(thing)) selected.value = [thing];
  },
  move(at, pressed) {
    const v = kept;
    if (!pressed || !taken || !v) return;
    moved = true;
    const depth = Math.max(0, snapped(-toMetres(v, size.peek(), at.x, at.y)[1], at.alt ? 0 : STEP_M));
    const { thing } = taken;
    const chosen = selected.peek().includes(thing) ? selected.peek() : [thing];
    drag((view) => {
      const from = placeOf(view, thing);
      if (!from) return [];
      const by = depth - from[2];
      const places = chosen.flatMap((id) => {
        const place = placeOf(view, id);
        return place ? [[id, [place[0], place[1], place[2] + by] as Ned] as const] : [];
      });
      return moveEdits(view, new Map(places));
    });
  },
  release(_at, cancelled) {
    if (cancelled) letGo();
    else if (moved) drop("Change the depth");
    taken = undefined;
  },
  wheel: () => undefined,
  pinch: () => undefined,
  leave: () => undefined,
};

export function Profile() {
  const v = viewportOf(size.value);
  return (
    <section class="panel profile" aria-label="Depth profile">
      <header class="panel-head">
        <h2>Depth along the way</h2>
        <span class="unit">m</span>
        <span class="grow" />
        <Legend />
      </header>
      <div class="profile-body">
        <Surface
          name="Depth profile"
          scene={scene}
          paint={paintProfile}
          gestures={gestures}
          onKey={onPlanKey}
          onSize={(next) => {
            size.value = next;
          }}
          cursor="default"
          describedBy="plan-keys"
          frame={[v.x, v.y, v.sx, v.sy].map((number) => number.toFixed(5)).join(" ")}
        />
      </div>
    </section>
  );
}

function Legend() {
  const nominal = plan.forecast.value?.nominal;
  if (!nominal) return <span class="hint">drag points up and down</span>;
  const { saturation, worst_actuator, depth_error_m } = nominal.track;
  const most = saturation.reduce((best, load, i) => (load > (saturation[best] ?? 0) ? i : best), 0);
  const clearance = plan.forecast.value?.floor?.least_m;
  const error = Math.max(...depth_error_m.map(Math.abs));
  return (
    <span class="hint ellipsis">
      <i class="swatch band" /> depth error up to <span class="num">{fixed(error, 2)} m</span>
      {clearance !== null && clearance !== undefined && (
        <>
          <i class="swatch floor" /> clearance <span class="num">{fixed(clearance, 1)} m</span>
        </>
      )}
      <i class="swatch load" /> most used {worst_actuator[most]}{" "}
      <span class="num">{fixed(100 * (saturation[most] ?? 0), 0)} %</span>
    </span>
  );
}
