import { describe, expect, it } from "vitest";
import type { RunSummary } from "../api/types";
import { isPiece, shownRuns } from "./filter";
import { viewsOf } from "./saved_views";

const run = (id: string, more: Partial<RunSummary> = {}): RunSummary =>
  ({
    id,
    run_id: id,
    mission: "docking",
    title: "",
    note: "",
    vehicle: "ts100",
    outcome_reason: "",
    tags: [],
    state: "complete",
    outcome: "docked",
    recorded: "2026-01-01T00:00:00Z",
    ...more,
  }) as RunSummary;

describe("the list of runs", () => {
  it("is sorted by the server's clock: a vehicle's of 1970 puts no run at the end", () => {
    const old = run("19700101T000000Z-a", { recorded: "2026-03-01T00:00:00Z" });
    const list = [run("20260101T000000Z-b"), old, run("20260102T000000Z-c", { state: "recording" })];
    expect(shownRuns(list, { words: "", outcome: "" }).map(({ id }) => id)).toEqual([
      "20260102T000000Z-c",
      "19700101T000000Z-a",
      "20260101T000000Z-b",
    ]);
  });

  it("is searched in title, tags, note and mission, and filtered by ending", () => {
    const list = [
      run("a", { title: "Calm sea" }),
      run("b", { tags: ["sea"], outcome: "held" }),
      run("c", { note: "rough SEA" }),
    ];
    const ids = (words: string, outcome = "") => shownRuns(list, { words, outcome }).map(({ id }) => id);
    expect(ids("sea").sort()).toEqual(["a", "b", "c"]);
    expect(ids("sea dock calm")).toEqual(["a"]);
    expect(ids("", "held")).toEqual(["b"]);
  });

  it("knows the hold after a flight as a piece of it", () => {
    expect(isPiece(run("a.2", { run_id: "a" }))).toBe(true);
    expect(isPiece(run("a"))).toBe(false);
  });

  it("keeps the pieces of one flight together, the first above", () => {
    const list = [
      run("a", { recorded: "2026-01-01T00:00:00Z" }),
      run("b", { recorded: "2026-01-02T00:00:00Z" }),
      run("a.2", { run_id: "a", recorded: "2026-01-03T00:00:00Z" }),
      run("a.10", { run_id: "a", recorded: "2026-01-03T00:00:01Z" }),
    ];
    expect(shownRuns(list, { words: "", outcome: "" }).map(({ id }) => id)).toEqual([
      "a",
      "a.2",
      "a.10",
      "b",
    ]);
  });
});

describe("saved views", () => {
  it("are read again, and nothing else is taken for one", () => {
    const view = { words: "calm", outcome: "docked" };
    expect(viewsOf(JSON.stringify({ Calm: view, strange: 3, other: { words: 1 } }))).toEqual({ Calm: view });
    for (const text of [null, "", "{", "[]", "3"]) expect(viewsOf(text)).toEqual({});
  });
});
