import { describe, expect, it } from "vitest";
import type { Figures } from "../map/figures";
import { approachStrip } from "./strip";

const FIGURES: Figures = {
  sight: 10,
  halfAngle: 40,
  thresholds: { rh: 1, fr: 8 },
  docks: true,
  entry: 10,
  keepOut: 4,
  cone: { base: 0.4, slope: 0.15 },
};

describe("the approach in space", () => {
  it("is as wide as the vehicle's cone at both ends, before the observation point, at its depth", () => {
    const [near, far, farOther, nearOther] = approachStrip([20, 5, 3], 0, FIGURES);
    expect(near).toEqual([20, 5.4, 3]);
    expect(nearOther?.[1]).toBeCloseTo(4.6);
    expect(far?.[0]).toBeCloseTo(10);
    expect((far?.[1] ?? 0) - (farOther?.[1] ?? 0)).toBeCloseTo(2 * 1.9);
  });
});
