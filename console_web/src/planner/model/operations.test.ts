import { beforeEach, describe, expect, it } from "vitest";
import { observationPoint } from "./geometry";
import * as op from "./operations";
import { drag, drop, edit, letGo, mission, open, redo, selected, text, undo, undoLabel } from "./plan";
import { blank, freeName } from "./templates";

beforeEach(() => open(blank("harbour", "ts100")));

function drawn(): void {
  op.addWaypoint(6, 0);
  op.addWaypoint(12, 1);
  op.addWaypoint(18, 3);
  op.placeDock([24, 4, 2], 0);
}

describe("drawing", () => {
  it("makes a way and a leg that leads to the dock's observation point", () => {
    drawn();
    const { legs, dock } = mission.value;
    expect(legs.map(({ at }) => at)).toEqual([
      [6, 0, 2],
      [12, 1, 2],
      [18, 3, 2],
      [22.5, 4, 2],
    ]);
    expect(dock).toMatchObject({ at: [24, 4, 2], heading: 0, standoff: 1.5 });
    expect(text.value).toContain("  - {to_ned_m: [12, 1, 2], speed_mps: 0.7}\n");
    expect(text.value).toContain("# Positions are NED");
  });

  it("puts a later waypoint before the leg that leads to the dock", () => {
    drawn();
    op.addWaypoint(20, 4);
    expect(mission.value.legs.map(({ at }) => at[0])).toEqual([6, 12, 18, 20, 22.5]);
    expect(selected.value).toEqual(["leg:3"]);
  });

  it("takes the observation point along when the dock moves, turns or stands off farther", () => {
    drawn();
    edit("Turn", op.dockEdits(mission.value, { heading: 90 }));
    expect(op.joined(mission.value)).toBe(true);
    edit("Off", op.dockEdits(mission.value, { standoff: 3 }));
    edit("Move", op.moveEdits(mission.value, new Map([["dock", [30, 4, 2.5]]])));
    const { legs, dock } = mission.value;
    expect(legs.at(-1)?.at).toEqual(observationPoint([30, 4, 2.5], 90, 3).map((v) => Number(v.toFixed(3))));
    expect(dock?.at).toEqual([30, 4, 2.5]);
  });
});

describe("a drag", () => {
  it("is shown at once everywhere and is one step to undo", () => {
    drawn();
    const before = text.value;
    for (const north of [25, 26, 26, 27])
      drag((view) => op.moveEdits(view, new Map([["dock", [north, 4, 2]]])));
    expect(mission.value.dock?.at).toEqual([27, 4, 2]);
    expect(mission.value.legs.at(-1)?.at).toEqual([25.5, 4, 2]);
    expect(text.value).toContain("position_ned_m: [27, 4, 2]");
    drop("Move");
    undo();
    expect(text.value).toBe(before);
    redo();
    expect(mission.value.dock?.at).toEqual([27, 4, 2]);
  });

  it("that is given up leaves nothing behind", () => {
    drawn();
    const [before, label] = [text.value, undoLabel.value];
    drag((view) => op.moveEdits(view, new Map([["start", [5, 5, 2]]])));
    letGo();
    expect([text.value, undoLabel.value]).toEqual([before, label]);
  });
});

describe("changes of the whole", () => {
  it("undo each other: there and back, a full turn, a shift and its contrary", () => {
    drawn();
    const places = (): unknown => [
      mission.value.start.at,
      mission.value.legs.map(({ at }) => at),
      mission.value.dock?.at,
    ];
    const before = places();
    op.reverse();
    expect(mission.value.start.at).toEqual([18, 3, 2]);
    op.reverse();
    for (let i = 0; i < 4; i++) op.rotateBy(90);
    selected.value = [];
    op.shiftBy([1, 2, 0.5]);
    op.shiftBy([-1, -2, -0.5]);
    expect(places()).toEqual(before);
  });

  it("never lift anything above the surface", () => {
    drawn();
    selected.value = ["leg:0"];
    op.shiftBy([0, 0, -9]);
    expect(mission.value.legs[0]?.at[2]).toBe(0);
  });

  it("copy, paste and delete what is selected", () => {
    drawn();
    selected.value = ["leg:0", "leg:1"];
    const clip = op.copied();
    expect(op.paste(clip ?? "")).toBe(true);
    expect(mission.value.legs.map(({ at }) => at[0])).toEqual([6, 12, 8, 14, 18, 22.5]);
    expect(selected.value).toEqual(["leg:2", "leg:3"]);
    op.deleteSelected();
    expect(mission.value.legs).toHaveLength(4);
    expect(op.paste("something else")).toBe(false);
  });
});

describe("text that can't be read", () => {
  it("keeps the last drawing and refuses edits by the views", async () => {
    drawn();
    const { setText } = await import("./plan");
    setText(`${text.value}  legs: [`, "typed");
    expect(mission.value.legs).toHaveLength(4);
    const wrong = text.value;
    op.addWaypoint(1, 1);
    expect(text.value).toBe(wrong);
  });
});

describe("names", () => {
  it("are free, short and fit for a file", () => {
    expect(freeName("docking", new Set(["docking", "docking_2"]))).toBe("docking_3");
    expect(freeName("my plan.v2", new Set())).toBe("my_plan_v2");
    expect(freeName("…", new Set())).toBe("mission");
  });
});
