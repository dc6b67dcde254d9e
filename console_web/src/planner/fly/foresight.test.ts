import { describe, expect, it } from "vitest";
import { type Flight, type Forecast, othersIn, percent, told, worst } from "./foresight";

const START: Forecast = {
  text: "",
  problems: [],
  findings: undefined,
  floor: undefined,
  station: undefined,
  nominal: undefined,
  flights: [],
  chance: undefined,
  of: 0,
  state: "flying",
  reason: "",
};
const flight = (seed: number, outcome: string, closest_m: number): Flight => ({
  number: seed,
  seed,
  outcome,
  end_s: 60,
  closest_m,
  clearance_m: null,
  north_m: [],
  east_m: [],
  depth_m: [],
});
const chance = {
  docked: 1,
  of: 2,
  low: 0.1,
  high: 0.9,
  counts: { docked: 187, waved_off: 2, time_over: 11 },
};

describe("a forecast", () => {
  it("grows with each message", () => {
    const messages = [
      { id: 1, kind: "findings", findings: [] },
      { id: 1, kind: "fan", flights: [flight(1, "docked", 0.4)], done: 1, of: 200, chance },
      { id: 1, kind: "fan", flights: [flight(2, "held", 0.6)], done: 2, of: 200, chance },
      { id: 1, kind: "done" },
    ] as const;
    const grown = messages.reduce<Forecast>((before, message) => told(before, message as never), START);
    expect([grown.flights.map(({ seed }) => seed), grown.of, grown.state]).toEqual([[1, 2], 200, "done"]);
  });
  it("ends with problems or a failure", () => {
    const problem = { line: 1, column: 1, field: "legs", value: "", rule: "must have 1 entry" };
    expect(told(START, { id: 1, kind: "problems", problems: [problem] } as never)).toMatchObject({
      state: "done",
      findings: [],
    });
    expect(told(START, { id: 1, kind: "failed", reason: "gone" })).toMatchObject({
      state: "failed",
      reason: "gone",
    });
  });
});

describe("chances", () => {
  it("are told with how the others end", () => {
    expect(othersIn(chance)).toBe("time over 11; waved off 2");
  });
  it("are never 100 % while one flight fails", () => {
    expect([percent(0.999), percent(1), percent(0.9)]).toEqual([99, 100, 90]);
  });
  it("have their worst flights first", () => {
    const flights = [flight(1, "docked", 9), flight(2, "held", 0.5), flight(3, "waved_off", 6)];
    expect(worst(flights, 5).map(({ seed }) => seed)).toEqual([3, 2]);
  });
});
