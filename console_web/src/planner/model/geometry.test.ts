import { describe, expect, it } from "vitest";
import {
  bearing,
  flown,
  legFacts,
  type Ned,
  niceStep,
  observationPoint,
  rotated,
  snapped,
  turn,
  wrapped,
} from "./geometry";

describe("headings", () => {
  it("go from north over east", () => {
    expect(bearing([0, 0, 0], [0, 5, 0])).toBeCloseTo(90);
    expect(bearing([0, 0, 0], [-1, -1, 0])).toBeCloseTo(225);
    expect([wrapped(-10), wrapped(370), turn(350, 20), turn(20, 350)]).toEqual([350, 10, 30, -30]);
  });
});

describe("places", () => {
  it("stand off the dock against its heading", () => {
    const [n, e, d] = observationPoint([26, 0, 2.3], 90, 1.5);
    expect([n, e, d].map((v) => Math.round(v * 1e6) / 1e6)).toEqual([26, -1.5, 2.3]);
  });
  it("turn about a point and keep their depth", () => {
    const [n, e, d] = rotated([2, 1, 5], [1, 1, 0], 90);
    expect([n, e, d].map((v) => Math.round(v * 1e6) / 1e6)).toEqual([1, 2, 5]);
  });
  it("snap to a grid, or not", () => {
    expect([snapped(1.24, 0.5), snapped(1.26, 0.5), snapped(1.26, 0)]).toEqual([1, 1.5, 1.26]);
  });
});

describe("legs", () => {
  const start: Ned = [0, 0, 2];
  it("have length, time and depth rate", () => {
    const [first, second] = legFacts(start, [
      { at: [3, 4, 2], speed: 0.5 },
      { at: [3, 4, 3], speed: 0 },
    ]);
    expect(first).toMatchObject({ length: 5, end: 5, seconds: 10, depthRate: 0 });
    expect(second).toMatchObject({ length: 1, end: 6, seconds: undefined, depthRate: undefined });
  });
  it("are as long as what is flown over ground", () => {
    expect(flown([0, 3, 3], [0, 4, 4])).toEqual([0, 5, 5]);
  });
});

describe("grid lines", () => {
  it("stand at 1, 2 or 5 times a power of ten", () => {
    expect([0.03, 0.9, 1, 1.1, 3, 700].map(niceStep)).toEqual([0.05, 1, 1, 2, 5, 1000]);
  });
});
