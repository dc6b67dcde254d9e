import { describe, expect, it } from "vitest";
import { currentAt } from "./grip_drag";
import { DIAL, dialScale, dialTip } from "./grips";
import { fitted, panned, toMetres, toPx, type Viewport, zoomed } from "./viewport";

const size = { width: 800, height: 500 };
const v: Viewport = { x: 3, y: -2, sx: 20, sy: 20, turn: 0.7 };

describe("the drawing's metres and pixels", () => {
  it("are each other's inverse, turned or not", () => {
    const [x, y] = toMetres(v, size, ...toPx(v, size, 5, 7));
    expect(x).toBeCloseTo(5);
    expect(y).toBeCloseTo(7);
  });
  it("have north up and east to the right", () => {
    const flat = { ...v, turn: 0 };
    const [x0, y0] = toPx(flat, size, 0, 0);
    const [x1, y1] = toPx(flat, size, 1, 1);
    expect([x1 - x0, y1 - y0].map(Math.round)).toEqual([20, -20]);
  });
  it("keep the point under the pointer while zooming", () => {
    const at = toMetres(v, size, 123, 77);
    const [x, y] = toPx(zoomed(v, size, 123, 77, 1.7), size, ...at);
    expect(x).toBeCloseTo(123);
    expect(y).toBeCloseTo(77);
  });
  it("go with the hand while panning", () => {
    const [x, y] = toPx(panned(v, size, 30, -12), size, ...toMetres(v, size, 100, 100));
    expect(x).toBeCloseTo(130);
    expect(y).toBeCloseTo(88);
  });
  it("hold all points when fitted", () => {
    const points = [
      [0, 0],
      [40, 3],
      [-5, 90],
    ] as const;
    const fit = fitted(points, size, 60, 0.3);
    for (const [x, y] of points) {
      const [a, b] = toPx(fit, size, x, y);
      expect(a >= 59.9 && a <= 740.1 && b >= 59.9 && b <= 440.1).toBe(true);
    }
  });
});

describe("the current's dial", () => {
  it("shows what was drawn on it", () => {
    const drawn = currentAt([DIAL.x + 21, DIAL.y], 0.25, { ...v, turn: 0 }, false);
    expect(drawn.map((c) => Number(c.toFixed(6)))).toEqual([0, 0.13, 0]);
    const [x, y] = dialTip(drawn, { ...v, turn: 0 });
    expect([Math.round(x - DIAL.x), Math.round(y - DIAL.y)]).toEqual([22, 0]);
  });
  it("is stilled by letting go at its middle, and takes a wider scale for more", () => {
    expect(currentAt([DIAL.x + 2, DIAL.y], 0.25, v, false)).toEqual([0, 0, 0]);
    expect([0, 0.2, 0.3, 3].map((speed) => dialScale([speed, 0, 0]))).toEqual([0.25, 0.25, 0.5, 5]);
  });
});
