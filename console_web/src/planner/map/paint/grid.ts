// The water's grid with its names, and the scale.
import { colour, font } from "../../../lib/theme";
import { niceStep } from "../../model/geometry";
import { toMetres, toPx } from "../viewport";
import type { Ctx, Scene } from "./scene";

export function paintGrid(c: Ctx, s: Scene): void {
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
    if (northUp && at > (s.view.wave || s.waving ? 292 : 152) && at < height - 24) {
      c.textAlign = "left";
      c.fillText(`N ${name(y)}`, 5, at - 3);
    }
  }
}

export function paintScale(c: Ctx, s: Scene): void {
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
