import { describe, expect, it } from "vitest";
import { Mode } from "../gen/bumpless_pb";
import type { CycleRow } from "../stream/cycle_row";
import { idsOf, lines } from "./compared";

const run = (times: number[], of: (t: number) => number): CycleRow[] =>
  times.map((t) => ({
    time: 1e9 + t,
    missionTime: t,
    inForce: true,
    mode: Mode.HOVER,
    kappa: 1,
    row: { depth: of(t) },
  }));

describe("runs laid over each other", () => {
  it("begin where they are aligned", () => {
    const a = run([0, 1, 2, 3], (t) => t);
    const b = run([10, 11, 12], (t) => 100 + t);
    const moments = [
      { start: 0, hover: 1 },
      { start: 0, hover: 11 },
    ];
    const [x, first, second] = lines([a, b], moments, "hover", "depth");
    expect(x).toEqual([-1, 0, 1, 2]);
    expect(first).toEqual([0, 1, 2, 3]);
    expect(second).toEqual([110, 111, 112, null]);
  });

  it("keep a coarser line whole, and show nothing for what is no number", () => {
    const a = run([0, 0.5, 1], (t) => (t === 0.5 ? Number.NaN : t));
    const b = run([0, 1], (t) => t);
    const [, first, second] = lines([a, b], [{}, {}], "start", "depth");
    expect(first).toEqual([0, null, 1]);
    expect(second).toEqual([0, 0, 1]);
  });

  it("are those of the address, each once, six at most", () => {
    expect(idsOf("a,b,a,,c")).toEqual(["a", "b", "c"]);
    expect(idsOf("1,2,3,4,5,6,7")).toHaveLength(6);
    expect(idsOf(undefined)).toEqual([]);
  });
});
