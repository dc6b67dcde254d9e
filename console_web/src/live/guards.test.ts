import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { type Guard, GuardSchema } from "../gen/bumpless_pb";
import { shareOf, whenWords, wordsOf } from "./guards";

const guard = (more: Partial<Guard>): Guard => create(GuardSchema, more as never);

describe("a condition of a switch", () => {
  it("says what it is against its limit, met or not", () => {
    const range = { name: "range", unit: "m", limit: 0.6 };
    expect(wordsOf(guard({ ...range, value: 0.82 }))).toBe("range 0.82 > 0.60 m");
    expect(wordsOf(guard({ ...range, value: 0.5, met: true }))).toBe("range 0.50 ≤ 0.60 m");
    const dwell = { name: "dwell", unit: "s", limit: 3, atLeast: true };
    expect(wordsOf(guard({ ...dwell, value: 1.2 }))).toBe("dwell 1.2 of 3.0 s");
    const seen = { name: "seen in 5 frames", limit: 3, atLeast: true };
    expect(wordsOf(guard({ ...seen, value: 5, met: true }))).toBe("seen in 5 frames: 5 of 3");
    expect(wordsOf(guard({ name: "gate passed", limit: 1, atLeast: true }))).toBe("gate passed: not yet");
  });

  it("has a bar that is full when it is met, and never more", () => {
    expect(shareOf(guard({ value: 1, limit: 0.5 }))).toBe(0.5);
    expect(shareOf(guard({ value: 1.5, limit: 3, atLeast: true }))).toBe(0.5);
    expect(shareOf(guard({ value: 9, limit: 3, atLeast: true, met: true }))).toBe(1);
    expect(shareOf(guard({ value: Number.NaN, limit: 3 }))).toBe(0);
  });

  it("is foretold only where somebody can tell", () => {
    expect([whenWords(4.2), whenWords(0.1), whenWords(Number.NaN), whenWords(9999)]).toEqual([
      "in about 4 s",
      "now",
      "",
      "",
    ]);
  });
});
