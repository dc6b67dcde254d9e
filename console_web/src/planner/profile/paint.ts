// Depth along the way: what is planned, what will be flown with its depth error, and which mode flies it.
import { colour, font } from "../../lib/theme";
import type { Flight, Nominal, SeaFloor } from "../fly/foresight";
import { type Size, toPx, type Viewport } from "../map/viewport";
import { flat, flown, niceStep } from "../model/geometry";
import type { MissionView } from "../model/mission";

export interface ProfileScene {
  view: MissionView;
  size: Size;
  viewport: Viewport;
  selected: readonly string[];
  nominal: Nominal | undefined;
  picked: Flight | undefined;
  stale: boolean;
  bottom: number;
  floor: SeaFloor | undefined;
}

type Ctx = CanvasRenderingContext2D;
const MODES: Record<string, string> = { F: "--mode-forward", R: "--mode-reverse", H: "--mode-hover" };
export const STRIP_PX = 11; // the mode strip below, and the load strip below it
export const FOOT_PX = 40;

export interface Knot {
  thing: string;
  along: number;
  depth: number;
}

/** Start and ends of legs by distance in the plane. */
export function knots(view: MissionView): Knot[] {
  const found: Knot[] = [{ thing: "start", along: 0, depth: view.start.at[2] }];
  let [from, sum] = [view.start.at, 0];
  view.legs.forEach(({ at }, i) => {
    sum += flat(from, at);
    found.push({ thing: `leg:${i}`, along: sum, depth: at[2] });
    from = at;
  });
  if (view.dock) found.push({ thing: "dock", along: sum + flat(from, view.dock.at), depth: view.dock.at[2] });
  return found;
}

const ways = new WeakMap<readonly number[], number[]>();

export function wayOf(north: readonly number[], east: readonly number[]): number[] {
  const kept = ways.get(north) ?? flown(north, east);
  ways.set(north, kept);
  return kept;
}

export function paintProfile(c: Ctx, s: ProfileScene): void {
  paintGrid(c, s);
  if (s.floor) paintFloor(c, s, s.floor);
  else if (s.bottom > 0) paintBottom(c, s);
  paintPlanned(c, s);
  if (s.nominal) paintFlown(c, s, s.nominal);
  if (s.picked) paintPicked(c, s, s.picked);
  paintKnots(c, s);
}

const at = (s: ProfileScene, along: number, depth: number): readonly [number, number] =>
  toPx(s.viewport, s.size, along, -depth);

function line(c: Ctx, points: readonly (readonly [number, number])[]): void {
  c.beginPath();
  points.forEach(([x, y], i) => {
    if (i) c.lineTo(x, y);
    else c.moveTo(x, y);
  });
}

function paintGrid(c: Ctx, s: ProfileScene): void {
  const { width, height } = s.size;
  const v = s.viewport;
  c.lineWidth = 1;
  c.font = font("--text-2xs");
  const name = (value: number): string => String(Number(value.toFixed(6))).replace("-", "\u2212");
  const dx = niceStep(80 / v.sx);
  for (let x = 0; ; x += dx) {
    const [px] = at(s, x, 0);
    if (px > width) break;
    if (px < 0) continue;
    c.strokeStyle = colour("--grid");
    line(c, [
      [px, 0],
      [px, height - FOOT_PX],
    ]);
    c.stroke();
    c.fillStyle = colour("--ink-2");
    c.textAlign = "center";
    if (px > 60 && px < width - 20) c.fillText(`${name(x)} m`, px, height - FOOT_PX + 12);
  }
  const dy = niceStep(26 / v.sy);
  for (let y = 0; ; y += dy) {
    const [, py] = at(s, 0, y);
    if (py > height - FOOT_PX) break;
    if (py < 0) continue;
    c.strokeStyle = colour(y === 0 ? "--trace" : "--grid");
    line(c, [
      [0, py],
      [width, py],
    ]);
    c.stroke();
    c.fillStyle = colour("--ink-2");
    c.textAlign = "left";
    if (py > 12) c.fillText(y === 0 ? "surface" : `${name(y)} m`, 5, py - 3);
  }
}

function paintBottom(c: Ctx, s: ProfileScene): void {
  const [, y] = at(s, 0, s.bottom);
  c.fillStyle = colour("--line-2");
  c.globalAlpha = 0.5;
  c.fillRect(0, y, s.size.width, Math.max(0, s.size.height - FOOT_PX - y));
  c.globalAlpha = 1;
}

/** The sea floor along the planned way, and how near to it the mission lets the hull come. */
function paintFloor(c: Ctx, s: ProfileScene, floor: SeaFloor): void {
  const edge = s.size.height - FOOT_PX;
  const known = floor.along_m.flatMap((along, i) => {
    const depth = floor.floor_m[i];
    return depth === null || depth === undefined ? [] : [[along, depth] as const];
  });
  const [first] = known;
  const last = known.at(-1);
  if (!first || !last) return;
  const ground = known.map(([along, depth]) => at(s, along, depth));
  c.globalAlpha = s.stale ? 0.3 : 1;
  line(c, [[at(s, first[0], 0)[0], edge], ...ground, [at(s, last[0], 0)[0], edge]]);
  c.fillStyle = colour("--line-2");
  c.fill();
  c.strokeStyle = colour("--ink-2");
  c.lineWidth = 1.5;
  line(c, ground);
  c.stroke();
  if (floor.wanted_m > 0) {
    c.strokeStyle = colour("--alarm");
    c.lineWidth = 1;
    c.setLineDash([4, 4]);
    line(
      c,
      known.map(([along, depth]) => at(s, along, depth - floor.wanted_m)),
    );
    c.stroke();
    c.setLineDash([]);
  }
  c.globalAlpha = 1;
}

function paintPlanned(c: Ctx, s: ProfileScene): void {
  c.strokeStyle = colour("--ink-2");
  c.lineWidth = 1.5;
  c.setLineDash([7, 5]);
  line(
    c,
    knots(s.view).map((knot) => at(s, knot.along, knot.depth)),
  );
  c.stroke();
  c.setLineDash([]);
}

function paintFlown(c: Ctx, s: ProfileScene, nominal: Nominal): void {
  const { track } = nominal;
  const way = wayOf(track.north_m, track.east_m);
  const points = way.map((x, i) => at(s, x, track.depth_m[i] ?? 0));
  const wanted = way.map((x, i) => at(s, x, (track.depth_m[i] ?? 0) - (track.depth_error_m[i] ?? 0)));
  c.globalAlpha = s.stale ? 0.3 : 1;
  c.fillStyle = colour("--warning");
  const alpha = c.globalAlpha;
  c.globalAlpha = alpha * 0.22;
  line(c, [...points, ...wanted.reverse()]);
  c.fill();
  c.globalAlpha = alpha;
  let from = 0;
  for (let i = 1; i <= track.mode.length; i++) {
    if (i < track.mode.length && track.mode[i] === track.mode[from]) continue;
    c.strokeStyle = colour(MODES[track.mode[from] ?? ""] ?? "--trace");
    c.lineWidth = 2.5;
    line(c, points.slice(from, i + 1));
    c.stroke();
    paintStrip(
      c,
      s,
      points[from]?.[0] ?? 0,
      points[Math.min(i, points.length - 1)]?.[0] ?? 0,
      track.mode[from] ?? "",
    );
    from = i;
  }
  paintLoad(c, s, nominal, points);
  c.globalAlpha = 1;
}

function paintStrip(c: Ctx, s: ProfileScene, x0: number, x1: number, mode: string): void {
  const y = s.size.height - 2 * STRIP_PX - 1;
  c.fillStyle = colour(MODES[mode] ?? "--line-2");
  c.fillRect(x0, y, Math.max(1, x1 - x0), STRIP_PX);
  if (x1 - x0 < 14) return;
  c.fillStyle = colour("--on-mode");
  c.font = font("--text-3xs", 800);
  c.textAlign = "center";
  c.fillText(mode, (x0 + x1) / 2, y + STRIP_PX - 2);
}

/** How near its bound the most used actuator is: from nothing to full height and red. */
function paintLoad(
  c: Ctx,
  s: ProfileScene,
  nominal: Nominal,
  points: readonly (readonly [number, number])[],
): void {
  const { saturation } = nominal.track;
  const floor = s.size.height;
  for (let i = 1; i < points.length; i++) {
    const load = saturation[i] ?? 0;
    const [x0, x1] = [points[i - 1]?.[0] ?? 0, points[i]?.[0] ?? 0];
    c.fillStyle = colour(load > 0.98 ? "--alarm" : load > 0.8 ? "--warning" : "--line-2");
    const h = Math.max(1, load * STRIP_PX);
    c.fillRect(x0, floor - h, Math.max(1, x1 - x0 + 0.5), h);
  }
}

function paintPicked(c: Ctx, s: ProfileScene, flight: Flight): void {
  const way = wayOf(flight.north_m, flight.east_m);
  c.strokeStyle = colour("--alarm");
  c.lineWidth = 2;
  line(
    c,
    way.map((x, i) => at(s, x, flight.depth_m[i] ?? 0)),
  );
  c.stroke();
}

function paintKnots(c: Ctx, s: ProfileScene): void {
  for (const { thing, along, depth } of knots(s.view)) {
    const [x, y] = at(s, along, depth);
    const on = s.selected.includes(thing);
    c.fillStyle = colour(on ? "--accent" : "--panel");
    c.strokeStyle = colour(
      thing === "dock" ? "--warning" : on ? "--ink" : thing === "start" ? "--ink-2" : "--accent",
    );
    c.lineWidth = 2;
    c.beginPath();
    c.arc(x, y, on ? 7 : 5.5, 0, 2 * Math.PI);
    c.fill();
    c.stroke();
  }
}
