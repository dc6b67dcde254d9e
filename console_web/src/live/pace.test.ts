import { expect, it } from "vitest";
import { Mode } from "../gen/bumpless_pb";
import { cycle, frame, START_S, store } from "../stream/frames";
import { History } from "../stream/history";
import { showRun } from "../stream/screen";
import { isDue, pace } from "./pace";
import { window_s } from "./time_axis";

function flown() {
  const { live } = store();
  const history = new History(live);
  let until = Number.NaN;
  showRun({ source: live, history, until: () => until });
  const fly = (from: number, to: number): void => {
    for (let t = from; t < to; t += 0.05) live.receive(frame(cycle(t, Mode.FORWARD)));
  };
  const look = (time: number): void => {
    until = START_S + time;
  };
  return { fly, look };
}

/** Protects: a plot of two minutes in five hundred pixels is not drawn ten times a second for a tenth of a pixel. */
it("is due once what is shown has moved on by a pixel, and not before", () => {
  const { fly, look } = flown();
  window_s.value = 100;
  fly(0, 300);
  const due = pace();
  look(200);
  expect([due(200), due(200)]).toEqual([true, false]);
  look(200.4); // of half a second a pixel
  expect(due(200)).toBe(false);
  look(200.5);
  expect([due(200), due(200)]).toEqual([true, false]);
  look(150); // a seek back
  expect(due(200)).toBe(true);
});

/** Protects: rows that are read late, and another run, are drawn though the edge stands still. */
it("is due when there is more or other to show at the same place", () => {
  const { fly, look } = flown();
  fly(0, 200);
  look(150);
  const due = pace();
  expect([due(400), due(400)]).toEqual([true, false]);
  fly(200, 201);
  expect(due(400)).toBe(true);
  const other = flown();
  other.fly(0, 201);
  other.look(150);
  expect(due(400)).toBe(true);
});

it("is always due before the first value", () => {
  flown();
  const due = pace();
  expect([due(400), due(400)]).toEqual([true, true]);
});

/** Protects: with a draft flown ahead the window ended where that flight does, stood still, and so did the lines. */
it("is due when the newest value moves on within a window that holds still", () => {
  const last = { of: new History(), from: 0, to: 60, edge: 20, rows: 0, fresh: true };
  expect(isDue(last, { ...last, edge: 20.05 }, 0.1)).toBe(false);
  expect(isDue(last, { ...last, edge: 20.1 }, 0.1)).toBe(true);
});
