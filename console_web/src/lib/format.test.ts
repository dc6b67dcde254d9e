import { describe, expect, it } from "vitest";
import { age, bytes, clock, compact, fixed, headingOf, NONE, placesOf, signed } from "./format";

describe("numbers as an operator reads them", () => {
  it("shows nothing as a dash, never as a number", () => {
    for (const nothing of [null, undefined, Number.NaN, Number.POSITIVE_INFINITY]) {
      expect([fixed(nothing, 2), signed(nothing, 2), compact(nothing)]).toEqual([NONE, NONE, NONE]);
    }
  });
  it("has a true minus sign, and none before a zero that was only rounded", () => {
    expect(fixed(-1.25, 1)).toBe("\u22121.3");
    expect(fixed(-0.001, 2)).toBe("0.00");
    expect(signed(0.001, 2)).toBe("0.00");
    expect(signed(0.8, 2)).toBe("+0.80");
  });
  it("never reads a heading of 360", () => {
    expect([headingOf(359.97, 1), headingOf(-0.5, 1), headingOf(725, 0)]).toEqual(["0.0", "359.5", "5"]);
  });
  it("keeps small and large numbers short", () => {
    expect([compact(0.012345), compact(3.2e-9), compact(0), compact(-12.345)]).toEqual([
      "0.0123",
      "3.2e\u22129",
      "0",
      "\u221212.3",
    ]);
  });
});

describe("the marks of a scale", () => {
  it("have as many decimals as their step needs: 0.775 was written 0.78", () => {
    expect([5, 0.5, 0.1, 0.25, 0.02, 0.025, 0.0001].map(placesOf)).toEqual([0, 1, 1, 2, 2, 3, 3]);
  });
});

describe("times and sizes", () => {
  it("counts minutes, and hours when there are some", () => {
    expect([clock(59.9), clock(3661), clock(-5), clock(-0.4)]).toEqual([
      "00:59",
      "1:01:01",
      "\u221200:05",
      "00:00",
    ]);
  });
  it("tells ages in seconds, then as a clock", () => {
    expect([age(undefined), age(3.04), age(140)]).toEqual(["no data", "3.0 s", "02:20"]);
  });
  it("sizes as a file list does", () => {
    expect([bytes(999), bytes(2_345_678), bytes(5_000_000_000n), bytes(undefined)]).toEqual([
      "999 B",
      "2.3 MB",
      "5.00 GB",
      NONE,
    ]);
  });
});
