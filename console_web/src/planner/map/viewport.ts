// Between metres and pixels. Metres are [across, up] of a drawing; the plan has equal scales and may be turned.

export interface Viewport {
  /** Centre, in metres across and up. */
  x: number;
  y: number;
  /** Pixels per metre across and up. */
  sx: number;
  sy: number;
  /** Turn of the drawing, radians counter-clockwise: 0 is north up. */
  turn: number;
}

export interface Size {
  width: number;
  height: number;
}
export type Px = readonly [number, number];

export function toPx(v: Viewport, size: Size, x: number, y: number): Px {
  const [dx, dy] = [x - v.x, y - v.y];
  const [c, s] = [Math.cos(v.turn), Math.sin(v.turn)];
  return [size.width / 2 + (c * dx - s * dy) * v.sx, size.height / 2 - (s * dx + c * dy) * v.sy];
}

export function toMetres(v: Viewport, size: Size, px: number, py: number): readonly [number, number] {
  const [a, b] = [(px - size.width / 2) / v.sx, (size.height / 2 - py) / v.sy];
  const [c, s] = [Math.cos(v.turn), Math.sin(v.turn)];
  return [v.x + c * a + s * b, v.y - s * a + c * b];
}

/** So that the point under a pixel stays there. */
export function zoomed(v: Viewport, size: Size, px: number, py: number, by: number): Viewport {
  const [x, y] = toMetres(v, size, px, py);
  const next = { ...v, sx: limited(v.sx * by), sy: limited(v.sy * by) };
  const [nx, ny] = toMetres(next, size, px, py);
  return { ...next, x: next.x + x - nx, y: next.y + y - ny };
}

function limited(scale: number): number {
  return Math.min(2000, Math.max(0.005, scale));
}

export function panned(v: Viewport, size: Size, dx: number, dy: number): Viewport {
  const [x, y] = toMetres(v, size, size.width / 2 - dx, size.height / 2 - dy);
  return { ...v, x, y };
}

/** All points in view with a margin in pixels; scales equal unless `free`. */
export function fitted(
  points: readonly (readonly [number, number])[],
  size: Size,
  margin: number,
  turn = 0,
  least: readonly [number, number] = [6, 6],
  free = false,
): Viewport {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const a = points.map(([x, y]) => c * x - s * y);
  const b = points.map(([x, y]) => s * x + c * y);
  const [a0, a1, b0, b1] = points.length
    ? [Math.min(...a), Math.max(...a), Math.min(...b), Math.max(...b)]
    : [0, 0, 0, 0];
  const kx = Math.max(20, size.width - 2 * margin) / Math.max(least[0], a1 - a0);
  const ky = Math.max(20, size.height - 2 * margin) / Math.max(least[1], b1 - b0);
  const [sx, sy] = free ? [kx, ky] : [Math.min(kx, ky), Math.min(kx, ky)];
  const [ma, mb] = [(a0 + a1) / 2, (b0 + b1) / 2];
  return { x: c * ma + s * mb, y: -s * ma + c * mb, sx, sy, turn };
}
