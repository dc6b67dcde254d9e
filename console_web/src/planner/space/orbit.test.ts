import { describe, expect, it } from "vitest";
import type { Ned } from "../model/geometry";
import { around, Lens, nearer, type Orbit, slid, turned } from "./orbit";

const SIZE = { width: 800, height: 600 };
const ORBIT: Orbit = { at: [10, 0, 2], azimuth: 0.4, elevation: 0.6, distance: 30, stretch: 2 };

describe("the camera in space", () => {
  it("sees what it looks at in the middle, north ahead and depth below", () => {
    const lens = new Lens({ ...ORBIT, azimuth: 0 }, SIZE);
    expect(lens.see([10, 0, 2])?.slice(0, 2)).toEqual([400, 300]);
    const [north, east, down] = (
      [
        [12, 0, 2],
        [10, 2, 2],
        [10, 0, 4],
      ] as const
    ).map((p) => lens.see(p));
    expect(north?.[1]).toBeLessThan(300);
    expect(east?.[0]).toBeGreaterThan(400);
    expect(down?.[1]).toBeGreaterThan(300);
    expect(lens.see([-100, 0, 2])).toBeUndefined();
  });

  it("finds a place again under its pixel", () => {
    const lens = new Lens(ORBIT, SIZE);
    const place: Ned = [14, -3, 5];
    const [x = 0, y = 0] = lens.see(place) ?? [];
    const found = lens.placeAt(x, y, 5);
    for (const axis of [0, 1, 2] as const) expect(found?.[axis]).toBeCloseTo(place[axis], 6);
    expect(lens.placeAt(400, -1e6, 5)).toBeUndefined(); // above the horizon
  });

  it("cuts lines that go behind it and keeps within its bounds", () => {
    const [, behind] = new Lens(ORBIT, SIZE).seeLine([10, 0, 2], [-500, -200, 2]) ?? [];
    expect(behind?.[2]).toBeCloseTo(0.05);
    expect(turned(ORBIT, 0, 99).elevation).toBeLessThan(Math.PI / 2);
    expect(nearer(ORBIT, 1e9).distance).toBe(0.5);
    const moved = slid(ORBIT, SIZE, 100, 0);
    expect(new Lens(moved, SIZE).see([10, 0, 2])?.[0]).toBeCloseTo(500, 0);
  });

  it("goes so far that all is in view", () => {
    const places: Ned[] = [
      [0, 0, 0],
      [200, 10, 30],
    ];
    const lens = new Lens(around(ORBIT, SIZE, places), SIZE);
    for (const place of places) {
      const [x = -1, y = -1] = lens.see(place) ?? [];
      expect(x > 0 && x < 800 && y > 0 && y < 600).toBe(true);
    }
  });
});
