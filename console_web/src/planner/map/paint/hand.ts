// What the hand is doing: a measure or a box.
import { colour } from "../../../lib/theme";
import { type Ctx, px, type Scene } from "./scene";
import { text } from "./words";

export function paintMeasure(c: Ctx, s: Scene): void {
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

export function paintBox(c: Ctx, s: Scene): void {
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
