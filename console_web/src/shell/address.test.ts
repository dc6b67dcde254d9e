import { describe, expect, it } from "vitest";
import { addressOf, href } from "./address";

describe("the page's address", () => {
  it("names a view, what of it, and how", () => {
    expect(addressOf("#/runs/20260101T000000Z-docking-ab12?t=31.2&with=b")).toEqual({
      view: "runs",
      id: "20260101T000000Z-docking-ab12",
      query: { t: "31.2", with: "b" },
    });
    expect(addressOf("#/live")).toEqual({ view: "live", id: "", query: {} });
    expect(addressOf("#live").view).toBe("live");
    expect(addressOf("").view).toBe("");
  });

  it("comes back as it was written, whatever a name holds", () => {
    for (const id of ["plain", "a/b", "50 %", "ä?t=1&x#y"]) {
      expect(addressOf(href("plan", id, { t: 0, who: "a&b" }))).toEqual({
        view: "plan",
        id,
        query: { t: "0", who: "a&b" },
      });
    }
    expect(href("runs", "a", { t: undefined, x: "" })).toBe("#/runs/a");
    expect(addressOf("#/runs/%E0%A4%A").id).toBe("%E0%A4%A");
  });
});
