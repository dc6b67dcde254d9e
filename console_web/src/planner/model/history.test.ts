import { describe, expect, it } from "vitest";
import { History } from "./history";

describe("history", () => {
  it("goes back and forth without end", () => {
    const history = new History("0");
    for (let i = 1; i <= 1000; i++) history.add(String(i), `step ${i}`);
    for (let i = 999; i >= 0; i--) expect(history.undo()).toBe(String(i));
    expect(history.undo()).toBeUndefined();
    for (let i = 1; i <= 1000; i++) expect(history.redo()).toBe(String(i));
    expect(history.redo()).toBeUndefined();
  });

  it("joins steps of the same kind that follow each other", () => {
    const history = new History("");
    for (const text of ["a", "ab", "abc"]) history.add(text, "type", "typing");
    history.add("abc!", "move");
    expect([history.undo(), history.undo(), history.undo()]).toEqual(["abc", "", undefined]);
  });

  it("does not join over an undo, and forgets what was undone once something else is done", () => {
    const history = new History("");
    history.add("a", "type", "typing");
    history.undo();
    history.add("b", "type", "typing");
    expect([history.forth, history.undo()]).toEqual([undefined, ""]);
  });
});
