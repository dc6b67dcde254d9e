// Small figures that several parts of the plan are drawn with.
import { colour } from "../../../lib/theme";
import { along, type Ned } from "../../model/geometry";
import { type Ctx, px, type Scene, TAU } from "./scene";
import { text } from "./words";

export function note(c: Ctx, s: Scene, at: Ned, words: string, ink: string): void {
  const [x, y] = px(s, at);
  text(c, words, x, y + 14, ink, 400, { size: "--text-2xs", align: "center" });
}

export function dot(
  c: Ctx,
  x: number,
  y: number,
  r: number,
  fill: string,
  stroke: string,
  width = 1.5,
): void {
  c.fillStyle = colour(fill);
  c.strokeStyle = colour(stroke);
  c.lineWidth = width;
  c.beginPath();
  c.arc(x, y, r, 0, TAU);
  c.fill();
  c.stroke();
}

export function hull(c: Ctx, x: number, y: number, at: number, fill: string, stroke: string): void {
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

export function handle(c: Ctx, s: Scene, at: Ned, heading: number, metres: number): void {
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

export function paintLine(
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
