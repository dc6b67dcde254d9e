import { describe, expect, it } from "vitest";
import type { RunSummary } from "../api/types";
import { shownFlights } from "./filter";
import { asOne, flightsOf } from "./flights";

const run = (id: string, more: Partial<RunSummary> = {}): RunSummary =>
  ({
    id,
    run_id: id,
    piece: 1,
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

const piece = (flight: string, number: number, more: Partial<RunSummary> = {}): RunSummary =>
  run(number === 1 ? flight : `${flight}.${number}`, { run_id: flight, piece: number, bytes: 4, ...more });

describe("the list of runs", () => {
  it("is sorted by the server's clock: a vehicle's of 1970 puts no run at the end", () => {
    const old = run("19700101T000000Z-a", { recorded: "2026-03-01T00:00:00Z" });
    const list = [run("20260101T000000Z-b"), old, run("20260102T000000Z-c", { state: "recording" })];
    expect(shownFlights(list, { words: "", outcome: "" }).map(({ head }) => head.id)).toEqual([
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
    const ids = (words: string, outcome = "") =>
      shownFlights(list, { words, outcome }).map(({ head }) => head.id);
    expect(ids("sea").sort()).toEqual(["a", "b", "c"]);
    expect(ids("sea dock calm")).toEqual(["a"]);
    expect(ids("", "held")).toEqual(["b"]);
  });

  it("lists the pieces of one flight as one, with its newest time and all its bytes", () => {
    const list = [
      run("a", { recorded: "2026-01-01T00:00:00Z", bytes: 1, title: "Calm", duration_s: 90 }),
      run("b", { recorded: "2026-01-02T00:00:00Z", bytes: 1 }),
      piece("a", 10, { recorded: "2026-01-03T00:00:01Z", outcome: null, note: "late" }),
      piece("a", 2, { recorded: "2026-01-03T00:00:00Z", outcome: null, duration_s: 300 }),
    ];
    const [a, b] = shownFlights(list, { words: "", outcome: "" });
    expect(a?.pieces.map(({ id }) => id)).toEqual(["a", "a.2", "a.10"]);
    expect(b?.head.id).toBe("b");
    const one = asOne(a as NonNullable<typeof a>);
    expect([one.id, one.title, one.bytes, one.duration_s]).toEqual(["a", "Calm", 9, 90]);
    expect(one.recorded).toBe("2026-01-03T00:00:01Z");
    expect(shownFlights(list, { words: "late", outcome: "docked" })).toHaveLength(1);
  });

  it("says how a flight ended by its last piece that flew, and never forgets a collision", () => {
    const ends = (...outcomes: RunSummary["outcome"][]) =>
      asOne(flightsOf(outcomes.map((outcome, k) => piece("a", k + 1, { outcome })))[0] as never).outcome;
    expect(ends("interrupted", "docked")).toBe("docked");
    expect(ends("interrupted", "docked", null)).toBe("docked");
    expect(ends("collided", "held")).toBe("collided");
    expect(ends(null, null)).toBe(null);
  });

  it("tells a flight that goes on after a crash from a hold after its end", () => {
    const going = (outcome: RunSummary["outcome"]) =>
      flightsOf([
        piece("a", 1, { outcome }),
        piece("a", 2, { state: "recording", outcome: null }),
      ])[0] as never;
    expect(asOne(going("interrupted")).state).toBe("recording");
    expect(asOne(going("docked")).state).toBe("complete");
  });

  it("takes a copy of a piece for a run of its own", () => {
    const list = [run("a"), run("a-copy2", { run_id: "a", piece: 0 })];
    expect(flightsOf(list)).toHaveLength(2);
  });
});
