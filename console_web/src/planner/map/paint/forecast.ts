// What is foreseen: the fan of all flights, the nominal track by its modes and where it switches.
import { colour } from "../../../lib/theme";
import type { Flight } from "../../fly/foresight";
import type { Px } from "../viewport";
import { type Ctx, px, type Scene, TAU } from "./scene";
import { paintLine } from "./strokes";
import { text } from "./words";

const MODE_COLOURS: Record<string, string> = {
  F: "--mode-forward",
  R: "--mode-reverse",
  H: "--mode-hover",
};

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

export function paintFan(c: Ctx, s: Scene): void {
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

export function paintTrack(c: Ctx, s: Scene): void {
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
