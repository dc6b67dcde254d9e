import { describe, expect, it } from "vitest";
import { at, type Ghost } from "./ghost";
import { read } from "./signals";
import { stretches } from "./stretches";

const GHOST: Ghost = { name: "A", time: [0, 1, 2], columns: { depth: [1, null, 3], yaw: [359, 1, 5] } };

describe("a ghost", () => {
  it("is told at the row before, and not outside its time", () => {
    expect([-0.1, 0, 0.9, 1, 2, 2.1].map((t) => at(GHOST, "depth", t))).toEqual([null, 1, 1, null, 3, null]);
    expect(at(GHOST, "range", 1)).toBeNull();
    expect(at(GHOST, "depth", Number.NaN)).toBeNull();
  });
  it("keeps a heading beside the measured one", () => {
    expect(at(GHOST, "yaw", 0, 361)).toBe(359);
    expect(at(GHOST, "yaw", 1, 361)).toBe(361);
  });
});

describe("a band", () => {
  it("breaks where there is no reference", () => {
    const values = [1, 1, null, 1];
    expect(stretches(4, (i) => values[i])).toEqual([
      [0, 1],
      [3, 3],
    ]);
  });
});

describe("a kept layout", () => {
  it("survives what others wrote under its name", () => {
    for (const text of [null, "", "{", "[]", '"x"', '{"group":"Nope","own":7,"layouts":[1]}'])
      expect(read(text)).toEqual({ group: "Motion", own: ["depth", "range", "kappa"], layouts: {} });
    expect(read('{"group":"Own","own":["a",5],"layouts":{"mine":["b"]}}')).toEqual({
      group: "Own",
      own: ["a"],
      layouts: { mine: ["b"] },
    });
  });
});
