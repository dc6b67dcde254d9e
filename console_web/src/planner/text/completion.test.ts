import { describe, expect, it } from "vitest";
import { pathAbove } from "./completion";
import { difference } from "./difference";

describe("where a line lies", () => {
  const lines = [
    "version: 1",
    "target:",
    "  position_ned_m: [1, 2, 3]",
    "sensors:",
    "  outages:",
    "    - from_s: 1",
  ];
  it("follows the indentation", () => {
    expect(pathAbove(lines.slice(0, 3), 2)).toBe("target");
    expect(pathAbove(lines.slice(0, 5), 2)).toBe("sensors");
    expect(pathAbove(lines, 0)).toBe("");
  });
  it("knows entries of lists", () => {
    expect(pathAbove(lines, 6)).toBe("sensors.outages[]");
  });
});

describe("the difference of two texts", () => {
  it("is the smallest replacement", () => {
    expect(difference("abc", "abc")).toBeUndefined();
    expect(difference("a: 10\nb: 2", "a: 15\nb: 2")).toEqual({ from: 4, to: 5, insert: "5" });
    expect(difference("aa", "aaa")).toEqual({ from: 2, to: 2, insert: "a" });
  });
});
