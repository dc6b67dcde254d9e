// The plan itself: start, way and waypoints; and the vehicle as it is now.
import { colour } from "../../../lib/theme";
import type { Ned } from "../../model/geometry";
import { arm } from "../grips";
import { angle, type Ctx, px, type Scene } from "./scene";
import { dot, handle, hull } from "./strokes";
import { text } from "./words";

export function paintWay(c: Ctx, s: Scene): void {
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

export function paintWaypoints(c: Ctx, s: Scene): void {
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

export function paintStart(c: Ctx, s: Scene): void {
  const { at, heading } = s.view.start;
  const [x, y] = px(s, at);
  const on = s.selected.includes("start");
  const dir = angle(s, heading);
  hull(c, x, y, dir, on ? "--accent" : "--panel", on ? "--ink" : "--ink-2");
  text(c, "Start", x + 12, y + 18, on ? "--ink" : "--ink-2", 600);
  if (!on) return;
  handle(c, s, at, heading, arm(s.viewport));
}

export function paintVehicle(c: Ctx, s: Scene, v: { north: number; east: number; heading: number }): void {
  const [x, y] = px(s, [v.north, v.east]);
  hull(c, x, y, angle(s, v.heading), "--good", "--ink");
}
