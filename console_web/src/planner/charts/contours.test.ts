import { describe, expect, it } from "vitest";
import { contoursOf, cornerPlace } from "./contours";

const CORNERS: [[number, number], [number, number], [number, number], [number, number]] = [
  [10, 0],
  [10, 20],
  [0, 20],
  [0, 0],
];

describe("a depth grid", () => {
  it("lies on its corners: first row left and right, last row right and left", () => {
    expect(cornerPlace(CORNERS, 0, 0)).toEqual([10, 0]);
    expect(cornerPlace(CORNERS, 1, 0)).toEqual([10, 20]);
    expect(cornerPlace(CORNERS, 1, 1)).toEqual([0, 20]);
    expect(cornerPlace(CORNERS, 0.5, 0.5)).toEqual([5, 10]);
  });

  it("has contour lines where its depth crosses them, none over what nobody knows", () => {
    const slope = { rows: 2, columns: 3, depth_m: [0, 4, 8, 0, 4, 8], least_m: 0, deepest_m: 8 };
    const two = contoursOf(slope).find(({ depth }) => depth === 2);
    expect(two?.lines).toEqual([[0.25, 0, 0.25, 1]]);
    const holed = { rows: 2, columns: 3, depth_m: [0, 4, 8, null, 4, 8], least_m: 0, deepest_m: 8 };
    expect(contoursOf(holed).find(({ depth }) => depth === 2)?.lines).toEqual([]);
  });
});
