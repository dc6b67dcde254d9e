import { describe, expect, it } from "vitest";
import { Mode } from "../gen/bumpless_pb";
import { shown, spans, ticks, timeLabel } from "../live/time_axis";
import { cycle, frame, START_S, store } from "./frames";
import { History, wrapDegrees } from "./history";

function flown(): {
  history: History;
  fly: (timeS: number, mode?: Mode, yawDeg?: number, past?: boolean) => void;
} {
  const { live } = store();
  const history = new History(live);
  const fly = (timeS: number, mode: Mode = Mode.FORWARD, yawDeg = 0, past = false): void =>
    live.receive(frame(cycle(timeS, mode, yawDeg), 0, past));
  return { history, fly };
}

/** Mission time, to the millisecond. */
const ms = (time: number): number => Math.round((time - START_S) * 1000) / 1000;
const times = (history: History): number[] => [...history.time.slice(0, history.length)].map(ms);

describe("the history", () => {
  it("takes a row for each cycle, also while nobody looks", () => {
    const { history, fly } = flown();
    for (const t of [0, 0.25, 0.5]) fly(t);
    expect(times(history)).toEqual([0, 0.25, 0.5]);
    expect(history.column("depth")?.[2]).toBe(3);
    expect(history.missionStart).toBe(START_S);
  });

  it("breaks the lines over a pause", () => {
    const { history, fly } = flown();
    for (const t of [0, 0.25, 5]) fly(t);
    expect(history.length).toBe(4);
    expect(history.column("depth")?.[2]).toBeNaN();
  });

  it("is filled by the past of a new connection without losing what is here", () => {
    const { history, fly } = flown();
    for (const t of [0, 0.25]) fly(t);
    for (const t of [0.1, 0.5]) fly(t, Mode.FORWARD, 0, true);
    expect(times(history)).toEqual([0, 0.25, 0.5]);
  });

  it("begins anew when the vehicle's clock goes back", () => {
    const { history, fly } = flown();
    for (const t of [10, 10.25, 1]) fly(t);
    expect(times(history)).toEqual([1]);
  });

  it("lets a heading go on past 360 so that its line never jumps", () => {
    const { history, fly } = flown();
    fly(0, Mode.FORWARD, 359);
    fly(0.25, Mode.FORWARD, 1);
    expect([...(history.column("yaw")?.slice(0, 2) ?? [])]).toEqual([359, 361]);
    expect([wrapDegrees(190), wrapDegrees(-190), wrapDegrees(180)]).toEqual([-170, 170, 180]);
  });

  it("holds ten minutes in columns that never grow", () => {
    const { history, fly } = flown();
    fly(0);
    const room = history.column("depth")?.length;
    for (let i = 1; i < 15_400; i++) fly(i / 20);
    expect(history.column("depth")?.length).toBe(room);
    expect(history.time.length).toBe(room);
    expect(history.last()).toBeCloseTo(START_S + 769.95, 3);
    expect(history.last() - history.first()).toBeGreaterThan(599);
  });
});

describe("the time axis", () => {
  it("shows the mission alone once it is old enough, else the last two minutes", () => {
    const { history, fly } = flown();
    for (let t = 0; t <= 40; t += 0.25) fly(t);
    expect(shown(history).map(ms)).toEqual([0, 40]);
    for (let t = 40.25; t <= 200; t += 0.25) fly(t);
    expect(shown(history).map(ms)).toEqual([80, 200]);
  });

  it("joins cycles of one mode into one stretch", () => {
    const { history, fly } = flown();
    for (const [t, mode] of [
      [0, 1],
      [0.25, 1],
      [0.5, 2],
      [0.75, 2],
    ] as [number, Mode][])
      fly(t, mode);
    const found = spans(START_S, START_S + 1, history).map(({ mode, start, end }) => [
      mode,
      ms(start),
      ms(end),
    ]);
    expect(found).toEqual([
      [Mode.FORWARD, 0, 0.5],
      [Mode.REVERSE, 0.5, 0.75],
    ]);
  });

  it("marks whole steps of mission time", () => {
    const { history, fly } = flown();
    for (let t = 0; t <= 25; t += 0.25) fly(t);
    const marks = ticks(START_S, START_S + 25, 10, history);
    expect(marks.map((t) => timeLabel(t, history.last(), history))).toEqual(["00:00", "00:10", "00:20"]);
  });

  it("is nowhere before the first value", () => {
    expect(shown(flown().history)).toEqual([Number.NaN, Number.NaN]);
  });
});
