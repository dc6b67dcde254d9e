import { describe, expect, it } from "vitest";
import { edited, patched, put, read, restructured, write } from "./document";
import { fieldOf, pathOf } from "./paths";

const FILES = import.meta.glob<string>("../../../../missions/*.yaml", {
  query: "?raw",
  import: "default",
  eager: true,
});
const docking = FILES["../../../../missions/docking.yaml"] ?? "";

describe("editing a mission's text", () => {
  it("changes a number where it stands and not one character else", () => {
    const made = edited(docking, [
      { path: ["legs", 1, "to_ned_m", 1], value: -3.5 },
      { path: ["target", "heading_deg"], value: 90 },
    ]);
    const lines = docking.split("\n");
    const changed = made.split("\n").filter((line, i) => line !== lines[i]);
    expect(changed).toEqual(["  - {to_ned_m: [24.5, -3.5, 2.3], speed_mps: 0.7}", "  heading_deg: 90"]);
  });

  it("adds what was not there, and keeps comments and order", () => {
    const made = edited(docking, [{ path: ["faults", 0], value: { actuator: "n_p", at_s: 5 } }]);
    expect(made).toBe(`${docking}faults:\n  - {actuator: n_p, at_s: 5}\n`);
  });

  it("takes away what is left empty", () => {
    const ended = edited(docking, [{ path: ["end", "hover_hold_s"], value: 10 }]);
    expect(edited(ended, [{ path: ["end", "hover_hold_s"], value: undefined }])).toBe(docking);
  });

  it.each(Object.entries(FILES))("can restructure %s without touching what it means", (_, before) => {
    const made = restructured(before, (doc) => put(doc, ["seed"], 99));
    expect(read(made).toJS()).toEqual({ ...read(before).toJS(), seed: 99 });
    const comments = (of: string): string[] => of.match(/#.*/g) ?? [];
    expect(comments(made)).toEqual(comments(before));
  });

  it("writes the files of the house as they are", () => {
    expect(write(read(docking), docking)).toBe(docking);
  });

  it("keeps the line ends and the mark of a file from another system", () => {
    const theirs = `\uFEFF${docking.replaceAll("\n", "\r\n")}`;
    const number = edited(theirs, [{ path: ["legs", 1, "to_ned_m", 1], value: -3.5 }]);
    expect(number).toBe(theirs.replace("[24.5, 0, 2.3]", "[24.5, -3.5, 2.3]"));
    expect(restructured(theirs, (doc) => put(doc, ["seed"], 99))).toBe(theirs.replace("seed: 1", "seed: 99"));
  });

  it("reads headings with leading zeros as decimal numbers", () => {
    expect(read("heading_deg: 045\n").toJS()).toEqual({ heading_deg: 45 });
  });
});

describe("paths", () => {
  it("are those of the server", () => {
    expect(pathOf("legs[0].to_ned_m")).toEqual(["legs", 0, "to_ned_m"]);
    expect(fieldOf(["sensors", "outages", 2, "from_s"])).toBe("sensors.outages[2].from_s");
  });
});

describe("a value while something is dragged", () => {
  it("is what the text will mean", () => {
    const edits = [
      { path: ["legs", 0, "to_ned_m", 0], value: 12 },
      { path: ["environment", "current_ned_mps"], value: [0, 0.1, 0] },
    ];
    expect(patched(read(docking).toJS(), edits)).toEqual(read(edited(docking, edits)).toJS());
  });
});
