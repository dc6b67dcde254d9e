import { describe, expect, it } from "vitest";
import { around, lineDiff } from "./line_diff";

const marks = (from: string, to: string): string =>
  lineDiff(from, to)
    .map(({ kind, text }) => ({ same: " ", gone: "-", new: "+" })[kind] + text)
    .join("|");

describe("the difference of two versions", () => {
  it("names what went and what came, in place", () => {
    expect(marks("a\nb\nc", "a\nx\nc")).toBe(" a|-b|+x| c");
    expect(marks("a\nb", "a\nb")).toBe(" a| b");
    expect(marks("", "a")).toBe("-|+a");
    expect(marks("a\nb\nc\nd", "b\nd\ne")).toBe("-a| b|-c| d|+e");
  });
  it("leaves out what is far from a change", () => {
    const lines = lineDiff("1\n2\n3\n4\n5\n6\n7\n8\n9", "x\n2\n3\n4\n5\n6\n7\n8\ny");
    expect(around(lines, 1).map((line) => line?.text ?? "…")).toEqual(["1", "x", "2", "…", "8", "9", "y"]);
  });
});
