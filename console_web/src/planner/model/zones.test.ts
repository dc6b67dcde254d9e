import { beforeEach, describe, expect, it } from "vitest";
import { addEvent, eventEdits, nudgeEvent } from "./events";
import * as op from "./operations";
import { edit, mission, open, selected, text, undo } from "./plan";
import { blank } from "./templates";
import { addZone, inside, setFence, splitSide } from "./zones";

const SQUARE = [
  [1, 1],
  [3, 1],
  [3, 4],
  [1, 4],
] as const;

beforeEach(() => open(blank("harbour", "ts100")));

describe("a keep-out zone", () => {
  it("is written as people write it, and taken back whole", () => {
    const before = text.value;
    addZone(SQUARE);
    expect(text.value).toContain(
      "keep_out:\n  - name: zone 1\n    corners:\n      - {north_m: 1, east_m: 1}\n      - {north_m: 3, east_m: 1}",
    );
    expect(text.value).toContain("# Positions are NED");
    expect(selected.value).toEqual(["zone:0"]);
    addZone(SQUARE);
    expect(mission.value.keepOut.map(({ name }) => name)).toEqual(["zone 1", "zone 2"]);
    undo();
    undo();
    expect(text.value).toBe(before);
  });

  it("moves whole or by a corner, number by number", () => {
    addZone(SQUARE);
    edit("Corner", op.moveEdits(mission.value, new Map([["corner:0.1", [5, 0.5, 0]]])));
    expect(mission.value.keepOut[0]?.corners[1]).toEqual([5, 0.5]);
    const from = op.placeOf(mission.value, "zone:0");
    edit(
      "Zone",
      op.moveEdits(mission.value, new Map([["zone:0", [(from?.[0] ?? 0) + 2, from?.[1] ?? 0, 0]]])),
    );
    expect(mission.value.keepOut[0]?.corners.map(([n]) => n)).toEqual([3, 7, 5, 3]);
  });

  it("loses corners until too few are left, then goes as a whole", () => {
    addZone(SQUARE);
    splitSide(0, 0, [0, 2]);
    expect(mission.value.keepOut[0]?.corners).toHaveLength(5);
    selected.value = ["corner:0.0", "corner:0.1"];
    op.deleteSelected();
    expect(mission.value.keepOut[0]?.corners).toHaveLength(3);
    selected.value = ["corner:0.2"];
    op.deleteSelected();
    expect(mission.value.keepOut).toEqual([]);
    expect(text.value).not.toContain("keep_out");
  });

  it("goes with the plan when all of it is shifted", () => {
    addZone(SQUARE);
    setFence(SQUARE.map(([n, e]) => [n * 10, e * 10]));
    selected.value = [];
    op.shiftBy([1, 2, 0]);
    expect(mission.value.keepOut[0]?.corners[0]).toEqual([2, 3]);
    expect(mission.value.keepIn?.[0]).toEqual([11, 12]);
  });

  it("knows its inside", () => {
    expect([inside(SQUARE, [2, 2]), inside(SQUARE, [0, 2]), inside(SQUARE, [2, 5])]).toEqual([
      true,
      false,
      false,
    ]);
  });
});

describe("faults and outages", () => {
  it("are added, moved and deleted, and leave nothing empty behind", () => {
    const before = text.value;
    addEvent("fault", 20, "n_p");
    addEvent("outage", 30);
    expect(text.value).toContain("faults:\n  - {actuator: n_p, at_s: 20, effectiveness: 0}");
    expect(text.value).toContain("    - {from_s: 30, to_s: 40}");
    nudgeEvent("outage:0", "to", 5);
    edit("Move", eventEdits(mission.value, "fault:0", "both", 25));
    expect(mission.value.events.outage[0]).toMatchObject({ from: 30, to: 45 });
    expect(mission.value.events.fault[0]).toMatchObject({ of: "n_p", from: 25, to: undefined });
    edit("Move", eventEdits(mission.value, "outage:0", "to", 10)); // never before it begins
    expect(mission.value.events.outage[0]).toMatchObject({ from: 30, to: 30 });
    selected.value = ["fault:0", "outage:0"];
    op.deleteSelected();
    expect(text.value).toBe(before);
  });
});
