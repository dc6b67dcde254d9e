// Keep-out zones, the keep-in boundary, and the outline that is being drawn.
import { colour } from "../../../lib/theme";
import type { Outline, Zone } from "../../model/mission";
import { cornerThing, outlineThing, type Which } from "../../model/things";
import { type Ctx, px, type Scene } from "./scene";
import { dot } from "./strokes";
import { text } from "./words";

const HATCH_PX = 9;

export function paintOutlines(c: Ctx, s: Scene): void {
  if (s.view.keepIn) paintFence(c, s, s.view.keepIn);
  s.view.keepOut.forEach((zone, i) => {
    paintZone(c, s, zone, i);
  });
}

function trace(c: Ctx, s: Scene, corners: Outline, closed = true): void {
  c.beginPath();
  corners.forEach((corner, i) => {
    const [x, y] = px(s, corner);
    if (i) c.lineTo(x, y);
    else c.moveTo(x, y);
  });
  if (closed) c.closePath();
}

function isOn(s: Scene, which: Which): boolean {
  return s.selected.some((thing) => thing === outlineThing(which) || thing.startsWith(`corner:${which}.`));
}

function paintFence(c: Ctx, s: Scene, corners: Outline): void {
  const on = isOn(s, "in");
  // All but the inside is shaded: the whole canvas and the outline, even-odd.
  trace(c, s, corners);
  c.rect(0, 0, s.size.width, s.size.height);
  c.fillStyle = colour("--reference");
  c.globalAlpha = 0.08;
  c.fill("evenodd");
  c.globalAlpha = 1;
  trace(c, s, corners);
  c.strokeStyle = colour("--reference");
  c.lineWidth = on ? 3 : 2;
  c.setLineDash([10, 4]);
  c.stroke();
  c.setLineDash([]);
  const [first] = corners;
  if (first) {
    const [x, y] = px(s, first);
    text(c, "keep in", x + 8, y - 8, "--reference", on ? 700 : 600);
  }
  if (on) paintCorners(c, s, corners, "in");
}

function paintZone(c: Ctx, s: Scene, zone: Zone, index: number): void {
  const on = isOn(s, index);
  const over = s.hovered === outlineThing(index);
  trace(c, s, zone.corners);
  c.fillStyle = colour("--alarm");
  c.globalAlpha = on || over ? 0.2 : 0.13;
  c.fill();
  c.globalAlpha = 0.35;
  hatch(c, s, zone.corners);
  c.globalAlpha = 1;
  trace(c, s, zone.corners);
  c.strokeStyle = colour("--alarm");
  c.lineWidth = on ? 2.5 : 1.5;
  c.stroke();
  const pixels = zone.corners.map((corner) => px(s, corner));
  const [x, y] = [Math.min(...pixels.map(([at]) => at)), Math.min(...pixels.map(([, at]) => at))];
  const words = [zone.name || "keep out", depths(zone)].filter(Boolean).join(", ");
  text(c, words, x, y - 7, "--alarm", on ? 700 : 600);
  if (on) paintCorners(c, s, zone.corners, index);
}

/** "2 to 5 m"; nothing when it reaches from the surface to the bottom. */
export function depths({ from, to }: Zone): string {
  if (to === undefined) return from > 0 ? `below ${from} m` : "";
  return from > 0 ? `${from} to ${to} m` : `down to ${to} m`;
}

function hatch(c: Ctx, s: Scene, corners: Outline): void {
  const pixels = corners.map((corner) => px(s, corner));
  const [x0, x1] = [Math.min(...pixels.map(([x]) => x)), Math.max(...pixels.map(([x]) => x))];
  const [y0, y1] = [Math.min(...pixels.map(([, y]) => y)), Math.max(...pixels.map(([, y]) => y))];
  const { width, height } = s.size;
  if (x1 < 0 || y1 < 0 || x0 > width || y0 > height) return;
  c.save();
  trace(c, s, corners);
  c.clip();
  c.strokeStyle = colour("--alarm");
  c.lineWidth = 1;
  c.beginPath();
  const [left, right] = [Math.max(0, x0), Math.min(width, x1)];
  const [top, bottom] = [Math.max(0, y0), Math.min(height, y1)];
  const first = Math.floor((left + top) / HATCH_PX) * HATCH_PX;
  for (let sum = first; sum < right + bottom; sum += HATCH_PX) {
    c.moveTo(sum - top, top);
    c.lineTo(sum - bottom, bottom);
  }
  c.stroke();
  c.restore();
}

function paintCorners(c: Ctx, s: Scene, corners: Outline, which: Which): void {
  corners.forEach((corner, i) => {
    const [x, y] = px(s, corner);
    const [bx, by] = px(s, corners.at(i - 1) ?? corner);
    if (Math.hypot(x - bx, y - by) >= 50) dot(c, (x + bx) / 2, (y + by) / 2, 3, "--well", "--ink-2");
    const on = s.selected.includes(cornerThing(which, i));
    const over = s.hovered === cornerThing(which, i);
    dot(c, x, y, on || over ? 7 : 5, on ? "--accent" : "--panel", on ? "--ink" : "--alarm", 2);
  });
}

/** What has been clicked so far of an outline. */
export function paintDrawn(c: Ctx, s: Scene): void {
  if (s.drawn.length === 0) return;
  const points = s.cursor ? [...s.drawn, s.cursor] : s.drawn;
  trace(c, s, points, false);
  c.strokeStyle = colour("--alarm");
  c.lineWidth = 2;
  c.setLineDash([6, 4]);
  c.stroke();
  c.setLineDash([]);
  s.drawn.forEach((corner, i) => {
    const [x, y] = px(s, corner);
    dot(c, x, y, i === 0 ? 7 : 4.5, i === 0 && s.drawn.length > 2 ? "--accent" : "--panel", "--alarm", 2);
  });
}
