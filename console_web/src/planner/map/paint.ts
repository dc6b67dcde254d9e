// The plan from above, drawn on a canvas: quick at any number of legs, without a graphics card.
import { colour, font } from "../../lib/theme";
import type { Flight, Nominal } from "../fly/foresight";
import { along, type Ned, niceStep, observationPoint, turn } from "../model/geometry";
import { approachOf, type MissionView } from "../model/mission";
import type { Figures } from "./figures";
import { arm, DIAL, dialScale, dialTip } from "./grips";
import { type Px, type Size, toMetres, toPx, type Viewport } from "./viewport";

export interface Scene {
  view: MissionView;
  viewport: Viewport;
  size: Size;
  selected: readonly string[];
  hovered: string | undefined;
  figures: Figures | undefined;
  nominal: Nominal | undefined;
  flights: readonly Flight[];
  picked: Flight | undefined;
  /** The way of the what-if variant. */
  variant: Nominal | undefined;
  /** The forecast is of an older text. */
  stale: boolean;
  vehicle: { north: number; east: number; heading: number } | undefined;
  box: readonly [number, number, number, number] | undefined;
  measured: readonly (readonly [number, number])[];
  cursor: readonly [number, number] | undefined;
}

type Ctx = CanvasRenderingContext2D;
const TAU = 2 * Math.PI;
const MODE_COLOURS: Record<string, string> = {
  F: "--mode-forward",
  R: "--mode-reverse",
  H: "--mode-hover",
};

export function paintPlan(c: Ctx, s: Scene): void {
  paintGrid(c, s);
  if (s.view.dock) paintDockZones(c, s, s.view.dock);
  paintFan(c, s);
  paintWay(c, s);
  paintTrack(c, s);
  if (s.variant) {
    c.setLineDash([9, 4]);
    paintLine(c, s, s.variant.track.north_m, s.variant.track.east_m, colour("--reference"), 2);
    c.setLineDash([]);
  }
  if (s.picked) paintLine(c, s, s.picked.north_m, s.picked.east_m, colour("--alarm"), 2);
  if (s.view.dock) paintDock(c, s, s.view.dock);
  paintStart(c, s);
  paintWaypoints(c, s);
  if (s.vehicle) paintVehicle(c, s, s.vehicle);
  paintMeasure(c, s);
  paintBox(c, s);
  paintDial(c, s);
  paintScale(c, s);
}

function px(s: Scene, [n, e]: Ned | readonly [number, number]): Px {
  return toPx(s.viewport, s.size, e as number, n as number);
}

function paintGrid(c: Ctx, s: Scene): void {
  const { width, height } = s.size;
  const step = niceStep(64 / s.viewport.sx);
  const corners = [
    toMetres(s.viewport, s.size, 0, 0),
    toMetres(s.viewport, s.size, width, 0),
    toMetres(s.viewport, s.size, 0, height),
    toMetres(s.viewport, s.size, width, height),
  ];
  const xs = corners.map(([x]) => x);
  const ys = corners.map(([, y]) => y);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  c.lineWidth = 1;
  c.font = font("--text-2xs");
  c.fillStyle = colour("--ink-2");
  const line = (ax: number, ay: number, bx: number, by: number, axis: boolean): void => {
    c.strokeStyle = colour(axis ? "--line-2" : "--grid");
    const [a, b] = [toPx(s.viewport, s.size, ax, ay), toPx(s.viewport, s.size, bx, by)];
    c.beginPath();
    c.moveTo(a[0], a[1]);
    c.lineTo(b[0], b[1]);
    c.stroke();
  };
  const northUp = s.viewport.turn === 0;
  const name = (v: number): string => String(Number(v.toFixed(6))).replace("-", "\u2212");
  for (let x = Math.ceil(x0 / step) * step; x <= x1; x += step) {
    line(x, y0, x, y1, Math.abs(x) < step / 2);
    const [at] = toPx(s.viewport, s.size, x, 0);
    if (northUp && at > 30 && at < width - 24) {
      c.textAlign = "center";
      c.fillText(`E ${name(x)}`, at, height - 6);
    }
  }
  for (let y = Math.ceil(y0 / step) * step; y <= y1; y += step) {
    line(x0, y, x1, y, Math.abs(y) < step / 2);
    const [, at] = toPx(s.viewport, s.size, 0, y);
    if (northUp && at > 152 && at < height - 24) {
      c.textAlign = "left";
      c.fillText(`N ${name(y)}`, 5, at - 3);
    }
  }
}

interface Ring {
  at: Ned;
  metres: number;
  ink: string;
  dash: number[];
  label: string;
  /** Heading from the middle at which the label stands. */
  towards: number;
}

function ring(c: Ctx, s: Scene, { at, metres, ink, dash, label, towards }: Ring): void {
  const [x, y] = px(s, at);
  const radius = metres * s.viewport.sx;
  if (radius < 3) return;
  c.strokeStyle = colour(ink);
  c.lineWidth = 1;
  c.setLineDash(dash);
  c.beginPath();
  c.arc(x, y, radius, 0, TAU);
  c.stroke();
  c.setLineDash([]);
  if (radius < 34) return;
  const way = angle(s, towards);
  const [lx, ly] = [x + (radius + 5) * Math.cos(way), y + (radius + 5) * Math.sin(way)];
  c.font = font("--text-2xs");
  c.fillStyle = colour(ink);
  c.textAlign = Math.cos(way) < 0 ? "right" : "left";
  c.fillText(label, lx, ly + 3);
}

/** Angle on the canvas of a heading. */
function angle(s: Scene, heading: number): number {
  return ((heading - 90) * Math.PI) / 180 - s.viewport.turn;
}

function paintDockZones(c: Ctx, s: Scene, wanted: NonNullable<MissionView["dock"]>): void {
  const dock = { ...wanted, heading: approachOf(wanted, s.view.current) };
  const f = s.figures;
  const [x, y] = px(s, dock.at);
  const k = s.viewport.sx;
  const end = observationPoint(dock.at, dock.heading, dock.standoff);
  if (f) {
    // From where the camera sees the marker with the bow on the approach heading.
    const half = (f.halfAngle * Math.PI) / 180;
    const back = angle(s, dock.heading + 180);
    c.fillStyle = colour("--accent");
    c.globalAlpha = 0.07;
    c.beginPath();
    c.moveTo(x, y);
    c.arc(x, y, f.sight * k, back - half, back + half);
    c.closePath();
    c.fill();
    c.globalAlpha = 0.5;
    c.strokeStyle = colour("--accent");
    c.setLineDash([2, 4]);
    c.lineWidth = 1;
    c.stroke();
    c.setLineDash([]);
    c.globalAlpha = 1;
    if (f.sight * k > 80)
      note(
        c,
        s,
        along(dock.at, dock.heading + 180 - f.halfAngle, f.sight),
        "camera sees the dock",
        "--accent",
      );
    if (f.docks) {
      const label = `keep out ${f.keepOut} m`;
      const towards = dock.heading + 60;
      ring(c, s, { at: dock.at, metres: f.keepOut, ink: "--alarm", dash: [6, 5], label, towards });
      paintCone(c, s, dock, end, f);
    }
    const rings = [
      { metres: f.thresholds.rh, ink: "--mode-hover", word: "hover" },
      { metres: f.thresholds.fr, ink: "--mode-reverse", word: "reverse" },
    ];
    for (const { metres, ink, word } of rings) {
      const label = `${word} ${metres} m`;
      ring(c, s, { at: end, metres, ink, dash: [3, 4], label, towards: dock.heading - 60 });
    }
  }
  if (dock.tolerance > 0 && dock.tolerance < 180 && !dock.intoCurrent) {
    const t = (dock.tolerance * Math.PI) / 180;
    const back = angle(s, wanted.heading + 180);
    c.fillStyle = colour("--reference");
    c.globalAlpha = 0.12;
    c.beginPath();
    c.moveTo(x, y);
    c.arc(x, y, Math.max(60, 6 * k), back - t, back + t);
    c.fill();
    c.globalAlpha = 1;
  }
}

function paintCone(c: Ctx, s: Scene, dock: { heading: number }, end: Ned, f: Figures): void {
  const side = (left: number, sign: number): Px =>
    px(
      s,
      along(along(end, dock.heading, -left), dock.heading + 90 * sign, f.cone.base + f.cone.slope * left),
    );
  const far = f.entry;
  const corners = [side(0, 1), side(far, 1), side(far, -1), side(0, -1)];
  c.beginPath();
  corners.forEach(([x, y], i) => {
    if (i) c.lineTo(x, y);
    else c.moveTo(x, y);
  });
  c.closePath();
  c.fillStyle = colour("--mode-hover");
  c.globalAlpha = 0.09;
  c.fill();
  c.globalAlpha = 0.55;
  c.strokeStyle = colour("--mode-hover");
  c.lineWidth = 1;
  c.stroke();
  c.globalAlpha = 1;
}

function note(c: Ctx, s: Scene, at: Ned, text: string, ink: string): void {
  const [x, y] = px(s, at);
  c.font = font("--text-2xs");
  c.fillStyle = colour(ink);
  c.textAlign = "center";
  c.fillText(text, x, y + 14);
}

const fans = new WeakMap<readonly Flight[], { count: number; path: Path2D }>();

/** All tracks as one path in metres: made once, drawn at any scale. */
function fanPath(flights: readonly Flight[]): Path2D {
  const kept = fans.get(flights);
  if (kept) return kept.path;
  const path = new Path2D();
  for (const { north_m, east_m } of flights) {
    north_m.forEach((n, i) => {
      if (i) path.lineTo(east_m[i] ?? 0, n);
      else path.moveTo(east_m[i] ?? 0, n);
    });
  }
  fans.set(flights, { count: flights.length, path });
  return path;
}

function paintFan(c: Ctx, s: Scene): void {
  if (s.flights.length === 0 || s.stale) return;
  const { viewport: v, size } = s;
  c.save();
  c.translate(size.width / 2, size.height / 2);
  c.rotate(-v.turn);
  c.scale(v.sx, -v.sy);
  c.translate(-v.x, -v.y);
  c.lineWidth = 1 / v.sx;
  c.strokeStyle = colour("--trace");
  c.globalAlpha = 0.13;
  c.stroke(fanPath(s.flights));
  c.restore();
}

function paintLine(
  c: Ctx,
  s: Scene,
  north: readonly number[],
  east: readonly number[],
  ink: string,
  width: number,
): void {
  c.strokeStyle = ink;
  c.lineWidth = width;
  c.beginPath();
  north.forEach((n, i) => {
    const [x, y] = px(s, [n, east[i] ?? 0]);
    if (i) c.lineTo(x, y);
    else c.moveTo(x, y);
  });
  c.stroke();
}

function paintTrack(c: Ctx, s: Scene): void {
  const track = s.nominal?.track;
  if (!track) return;
  c.globalAlpha = s.stale ? 0.3 : 1;
  c.lineWidth = 2.5;
  c.lineJoin = "round";
  let from = 0;
  for (let i = 1; i <= track.mode.length; i++) {
    if (i < track.mode.length && track.mode[i] === track.mode[from]) continue;
    const to = Math.min(i, track.mode.length - 1);
    paintLine(
      c,
      s,
      track.north_m.slice(from, to + 1),
      track.east_m.slice(from, to + 1),
      colour(MODE_COLOURS[track.mode[from] ?? ""] ?? "--trace"),
      2.5,
    );
    from = i;
  }
  c.globalAlpha = 1;
  if (s.stale) return;
  paintSwitches(c, s);
}

function paintSwitches(c: Ctx, s: Scene): void {
  const track = s.nominal?.track;
  if (!track || !s.nominal) return;
  let last: Px | undefined;
  for (const { t_s, to } of s.nominal.switches) {
    const i = track.t_s.findIndex((t) => t >= t_s);
    if (i < 0) continue;
    const [x, y] = px(s, [track.north_m[i] ?? 0, track.east_m[i] ?? 0]);
    c.fillStyle = colour(MODE_COLOURS[to] ?? "--ink");
    c.strokeStyle = colour("--well");
    c.lineWidth = 1.5;
    c.beginPath();
    c.arc(x, y, 4, 0, TAU);
    c.fill();
    c.stroke();
    if (last && Math.hypot(last[0] - x, last[1] - y) < 46) continue;
    last = [x, y];
    text(c, `${to} ${t_s.toFixed(0)} s`, x + 7, y + 14, "--ink-2");
  }
}

/** Text that stays legible over lines. */
function text(c: Ctx, words: string, x: number, y: number, ink: string, weight = 400): void {
  c.font = font("--text-xs", weight);
  c.textAlign = "left";
  c.lineWidth = 3;
  c.lineJoin = "round";
  c.strokeStyle = colour("--well");
  c.strokeText(words, x, y);
  c.fillStyle = colour(ink);
  c.fillText(words, x, y);
}

function paintWay(c: Ctx, s: Scene): void {
  const points = [s.view.start.at, ...s.view.legs.map((leg) => leg.at)];
  if (points.length < 2) return;
  c.strokeStyle = colour("--ink-2");
  c.lineWidth = 1.5;
  c.setLineDash([7, 5]);
  c.beginPath();
  points.forEach((p, i) => {
    const [x, y] = px(s, p);
    if (i) c.lineTo(x, y);
    else c.moveTo(x, y);
  });
  c.stroke();
  c.setLineDash([]);
  if (points.length > 80) return;
  c.fillStyle = colour("--ink-2");
  for (let i = 1; i < points.length; i++) {
    const [a, b] = [px(s, points[i - 1] as Ned), px(s, points[i] as Ned)];
    if (Math.hypot(b[0] - a[0], b[1] - a[1]) > 60)
      dot(c, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, 3, "--well", "--ink-2");
  }
}

function dot(c: Ctx, x: number, y: number, r: number, fill: string, stroke: string, width = 1.5): void {
  c.fillStyle = colour(fill);
  c.strokeStyle = colour(stroke);
  c.lineWidth = width;
  c.beginPath();
  c.arc(x, y, r, 0, TAU);
  c.fill();
  c.stroke();
}

function paintWaypoints(c: Ctx, s: Scene): void {
  const many = s.view.legs.length > 80;
  s.view.legs.forEach((leg, i) => {
    const [x, y] = px(s, leg.at);
    if (x < -20 || y < -20 || x > s.size.width + 20 || y > s.size.height + 20) return;
    const on = s.selected.includes(`leg:${i}`);
    const over = s.hovered === `leg:${i}`;
    dot(c, x, y, on || over ? 8 : 6.5, on ? "--accent" : "--panel", on ? "--ink" : "--accent", 2);
    if (!many || on) text(c, String(i + 1), x + 10, y - 8, on ? "--ink" : "--ink-2", on ? 700 : 600);
  });
}

function arrow(c: Ctx, x: number, y: number, at: number, length: number): void {
  c.save();
  c.translate(x, y);
  c.rotate(at);
  c.beginPath();
  c.moveTo(0, 0);
  c.lineTo(length, 0);
  c.moveTo(length - 6, -4);
  c.lineTo(length, 0);
  c.lineTo(length - 6, 4);
  c.stroke();
  c.restore();
}

function hull(c: Ctx, x: number, y: number, at: number, fill: string, stroke: string): void {
  c.save();
  c.translate(x, y);
  c.rotate(at);
  c.beginPath();
  c.moveTo(12, 0);
  c.lineTo(-8, 6);
  c.lineTo(-5, 0);
  c.lineTo(-8, -6);
  c.closePath();
  c.fillStyle = colour(fill);
  c.strokeStyle = colour(stroke);
  c.lineWidth = 2;
  c.fill();
  c.stroke();
  c.restore();
}

function paintStart(c: Ctx, s: Scene): void {
  const { at, heading } = s.view.start;
  const [x, y] = px(s, at);
  const on = s.selected.includes("start");
  const dir = angle(s, heading);
  hull(c, x, y, dir, on ? "--accent" : "--panel", on ? "--ink" : "--ink-2");
  text(c, "Start", x + 12, y + 18, on ? "--ink" : "--ink-2", 600);
  if (!on) return;
  handle(c, s, at, heading, arm(s.viewport));
}

function handle(c: Ctx, s: Scene, at: Ned, heading: number, metres: number): void {
  const [x, y] = px(s, at);
  const [hx, hy] = px(s, along(at, heading, metres));
  c.strokeStyle = colour("--accent");
  c.lineWidth = 1.5;
  c.beginPath();
  c.moveTo(x, y);
  c.lineTo(hx, hy);
  c.stroke();
  dot(c, hx, hy, 5.5, "--accent", "--ink", 1.5);
}

function paintDock(c: Ctx, s: Scene, dock: NonNullable<MissionView["dock"]>): void {
  const on = s.selected.includes("dock");
  const [x, y] = px(s, dock.at);
  const end = observationPoint(dock.at, dock.heading, dock.standoff);
  const [ox, oy] = px(s, end);
  handle(c, s, dock.at, dock.heading, arm(s.viewport));
  c.save();
  c.translate(x, y);
  c.rotate(angle(s, dock.heading));
  c.strokeStyle = colour("--warning");
  c.lineWidth = on ? 4 : 3;
  c.lineCap = "round";
  c.beginPath();
  c.moveTo(-9, -11);
  c.lineTo(4, -11);
  c.lineTo(4, 11);
  c.lineTo(-9, 11);
  c.stroke();
  c.restore();
  c.strokeStyle = colour("--mode-hover");
  c.lineWidth = 2;
  c.beginPath();
  c.arc(ox, oy, on ? 7 : 4, 0, TAU);
  c.stroke();
  text(c, dockLabel(dock, s.view.current), x + 14, y - 14, on ? "--ink" : "--ink-2", 600);
}

function dockLabel(dock: NonNullable<MissionView["dock"]>, current: Ned): string {
  const own = `Dock ${degrees(dock.heading)}`;
  const used = approachOf(dock, current);
  return Math.abs(turn(dock.heading, used)) > 0.5 ? `${own}, approach ${degrees(used)}` : own;
}

function degrees(heading: number): string {
  return `${heading.toFixed(0).padStart(3, "0")}°`;
}

function paintVehicle(c: Ctx, s: Scene, v: { north: number; east: number; heading: number }): void {
  const [x, y] = px(s, [v.north, v.east]);
  hull(c, x, y, angle(s, v.heading), "--good", "--ink");
}

function paintMeasure(c: Ctx, s: Scene): void {
  if (s.measured.length === 0) return;
  const points = s.cursor ? [...s.measured, s.cursor] : s.measured;
  c.strokeStyle = colour("--warning");
  c.lineWidth = 1.5;
  c.beginPath();
  points.forEach((p, i) => {
    const [x, y] = px(s, p);
    if (i) c.lineTo(x, y);
    else c.moveTo(x, y);
  });
  c.stroke();
  let sum = 0;
  for (let i = 1; i < points.length; i++) {
    const [a, b] = [points[i - 1] ?? [0, 0], points[i] ?? [0, 0]];
    sum += Math.hypot(b[0] - a[0], b[1] - a[1]);
  }
  const [a, b] = points.slice(-2);
  const last = b ?? a;
  if (!a || !last) return;
  const heading = b
    ? (((Math.atan2(b[1] - a[1], b[0] - a[0]) * 180) / Math.PI + 360) % 360).toFixed(0).padStart(3, "0")
    : "–";
  const [x, y] = px(s, last);
  text(c, `${sum.toFixed(2)} m, ${heading}°`, x + 10, y - 8, "--warning", 700);
}

function paintBox(c: Ctx, s: Scene): void {
  if (!s.box) return;
  const [x0, y0, x1, y1] = s.box;
  c.fillStyle = colour("--accent");
  c.globalAlpha = 0.12;
  c.fillRect(x0, y0, x1 - x0, y1 - y0);
  c.globalAlpha = 1;
  c.strokeStyle = colour("--accent");
  c.lineWidth = 1;
  c.strokeRect(x0, y0, x1 - x0, y1 - y0);
}

/** The current as a dial in the corner: its arrow is dragged. */
function paintDial(c: Ctx, s: Scene): void {
  const { x, y, radius } = DIAL;
  const scale = dialScale(s.view.current);
  const on = s.selected.includes("current");
  c.fillStyle = colour("--panel");
  c.globalAlpha = 0.85;
  c.beginPath();
  c.arc(x, y, radius + 14, 0, TAU);
  c.fill();
  c.globalAlpha = 1;
  c.strokeStyle = colour(on ? "--accent" : "--line-2");
  c.lineWidth = on ? 2 : 1;
  for (const share of [0.5, 1]) {
    c.beginPath();
    c.arc(x, y, radius * share, 0, TAU);
    c.stroke();
  }
  c.fillStyle = colour("--ink-2");
  c.font = font("--text-2xs", 600);
  c.textAlign = "center";
  const north = -s.viewport.turn - Math.PI / 2;
  c.fillText("N", x + (radius + 7) * Math.cos(north), y + (radius + 7) * Math.sin(north) + 4);
  const [tx, ty] = dialTip(s.view.current, s.viewport);
  const speed = Math.hypot(s.view.current[0], s.view.current[1]);
  c.strokeStyle = colour("--trace");
  c.lineWidth = 2.5;
  if (speed > 1e-6) arrow(c, x, y, Math.atan2(ty - y, tx - x), Math.hypot(tx - x, ty - y));
  dot(c, tx, ty, speed > 1e-6 ? 4 : 5.5, "--trace", "--well", 1.5);
  c.fillStyle = colour("--ink");
  c.font = font("--text-2xs", 600);
  c.textAlign = "center";
  c.fillText(speed > 1e-6 ? `current ${speed.toFixed(2)} m/s` : "no current", x, y + radius + 26);
  c.fillStyle = colour("--ink-2");
  c.fillText(`${scale} m/s`, x, y + radius + 10);
}

function paintScale(c: Ctx, s: Scene): void {
  const metres = niceStep(70 / s.viewport.sx);
  const length = metres * s.viewport.sx;
  const [x, y] = [s.size.width - 14 - length, s.size.height - 24];
  c.strokeStyle = colour("--ink-2");
  c.lineWidth = 1.5;
  c.beginPath();
  c.moveTo(x, y - 4);
  c.lineTo(x, y);
  c.lineTo(x + length, y);
  c.lineTo(x + length, y - 4);
  c.stroke();
  c.font = font("--text-2xs");
  c.fillStyle = colour("--ink-2");
  c.textAlign = "center";
  c.fillText(`${metres} m`, x + length / 2, y - 5);
}
