import { expect, test } from "vitest";
import { extent, flowWords, type Held, headingsOf, teeth } from "./held";

const held: Held = {
  current_ned_mps: [-0.1, 0, 0],
  heading_deg: 0,
  zone: "accepted",
  reason: "",
  arcs: [
    { zone: "accepted", from_deg: 350, to_deg: 10 },
    { zone: "warned", from_deg: 11, to_deg: 11 },
    { zone: "refused", from_deg: 12, to_deg: 349 },
  ],
};

test("arcs together are the whole circle, also through north", () => {
  expect(held.arcs.reduce((sum, arc) => sum + extent(arc).width, 0)).toBe(360);
  expect(extent({ zone: "accepted", from_deg: 0, to_deg: 359 }).width).toBe(360);
});

test("headings are said in three digits, as the check says them", () => {
  expect(headingsOf(held, "accepted")).toBe("350° to 010°");
  expect(headingsOf(held, "warned")).toBe("011°");
  const any: Held = { ...held, arcs: [{ zone: "accepted", from_deg: 0, to_deg: 359 }] };
  expect(headingsOf(any, "accepted")).toBe("any heading");
  expect(headingsOf(any, "refused")).toBe("");
});

test("a current is said by where it comes from, and still water has no direction", () => {
  expect(flowWords([-0.1, 0, 0])).toBe("0.10 m/s from 000°");
  expect(flowWords([0, -0.05])).toBe("0.05 m/s from 090°");
  expect(flowWords([0.001, 0])).toBe("no current");
});

test("even the narrowest refused arc has a tooth: colour alone says nothing", () => {
  expect(teeth(10, 1)).toHaveLength(1);
  expect(teeth(0, 360).length).toBeGreaterThan(20);
});
