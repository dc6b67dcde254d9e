import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { WrenchSchema } from "../gen/bumpless_pb";
import { acts, gauge, marginOf, type Reach, slice } from "./reach";

/** A box of these half widths as rows d / h(d). */
function box(...half: number[]): number[][] {
  return half.flatMap((h, axis) => [1, -1].map((sign) => [0, 1, 2].map((k) => (k === axis ? sign / h : 0))));
}

const reach: Reach = {
  sha256: "",
  surge_mps: 0,
  force: box(4, 1, 2),
  moment: box(1, 2, 4),
  low: [],
  high: [],
  most: [],
};

describe("the attainable sets", () => {
  it("say what share of them a demand uses, in its own direction", () => {
    expect(gauge(reach.force, [2, 0.25, 0])).toBe(0.5);
    expect(marginOf(create(WrenchSchema, { xN: 1, mNm: 1.5 }), reach)).toBe(0.25);
    expect(marginOf(create(WrenchSchema, {}), reach)).toBe(1);
    expect(marginOf(create(WrenchSchema, { zN: -9 }), reach)).toBe(0);
  });

  it("say nothing of a demand that is no number", () => {
    expect(marginOf(create(WrenchSchema, { xN: Number.NaN }), reach)).toBeUndefined();
    expect(marginOf(undefined, reach)).toBeUndefined();
  });

  it("are cut where the plane meets them, and not beside", () => {
    const cut = slice(reach.force, 0, 2, 0.5, 360);
    expect(Math.max(...cut.map(([x]) => x))).toBeCloseTo(4, 6);
    expect(Math.max(...cut.map(([, z]) => z))).toBeCloseTo(2, 6);
    expect(slice(reach.force, 0, 2, 1.5)).toEqual([]);
  });

  it("have no width along an axis on which nothing acts now, though something may at another speed", () => {
    const still = { ...reach, most: [4, 85, 2], high: [4, 0, 2], low: [-4, 0, -2] };
    expect([0, 1, 2].map((axis) => acts(still, axis))).toEqual([1, 0, 1]);
  });
});
