import { describe, expect, it } from "vitest";
import { beginning, below, declared, type FieldEntry, rangeOf, refusal, typed } from "./fields";

const field = (path: string, more: Partial<FieldEntry> = {}): FieldEntry => ({
  path,
  type: "number",
  label: path,
  help: "",
  unit: "m",
  required: true,
  nullable: false,
  ...more,
});
const ALL = [
  field("sensors", { type: "part" }),
  field("sensors.outages", { type: "list" }),
  field("sensors.outages[].from_s", { min: 0, max: 10 }),
  field("sensors.outages[].note", { type: "text", required: false }),
];

describe("declared fields", () => {
  it("are found below their part or list", () => {
    expect(declared(["sensors", "outages", 3, "from_s"])).toBe("sensors.outages[].from_s");
    expect(below(ALL, "sensors").map(({ path }) => path)).toEqual(["sensors.outages"]);
    expect(below(ALL, "sensors.outages[]")).toHaveLength(2);
  });
  it("begin with what is required", () => {
    expect(beginning(ALL, "sensors.outages[]")).toEqual({ from_s: 0 });
  });
  it("refuse what is out of range, component by component", () => {
    const row = field("p", { min: [-1, -1, 0], max: [1, 1, 11000] });
    expect([refusal(row, -0.5, 0), refusal(row, -0.5, 2)]).toEqual(["", "must be at least 0"]);
    expect(refusal(field("n", { type: "integer" }), 1.5)).toBe("must be a whole number");
    expect(rangeOf(row, 2)).toBe("0 to 11000 m");
  });
});

describe("typed numbers", () => {
  it("are read as people write them", () => {
    expect(["1,5", " −3 ", "045", "1e-3", ".5", "1.", "", "x", "1 2"].map(typed)).toEqual([
      1.5,
      -3,
      45,
      0.001,
      0.5,
      1,
      undefined,
      undefined,
      undefined,
    ]);
  });
});
