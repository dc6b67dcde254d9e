import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { MissionPhase, Mode, NavigationSchema, type Supervisor, SupervisorSchema } from "../gen/bumpless_pb";
import { shown, spans, ticks, timeLabel } from "../live/time_axis";
import { cycle, frame, START_S, said, stamp, store } from "./frames";
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

/** Cycles whose supervisor says what a test says. */
function told() {
  const { live } = store();
  const history = new History(live);
  const say = (timeS: number, said_: Partial<Supervisor>): void => {
    const at = stamp(timeS);
    live.receive(
      frame([
        said(
          "tlm/supervisor",
          SupervisorSchema,
          create(SupervisorSchema, { phase: MissionPhase.RUNNING, ...said_, stamp: at } as never),
        ),
        said("tlm/navigation", NavigationSchema, { stamp: at, depthM: 3 }),
      ]),
    );
  };
  return { history, say };
}

/** A cycle that only tells where the vehicle is. */
function place(
  history: History,
  timeS: number,
  of: { depth: number; missionTime: number; inForce: boolean },
) {
  const { depth, missionTime, inForce } = of;
  const mode = inForce ? Mode.FORWARD : Mode.UNSPECIFIED;
  history.append({
    time: START_S + timeS,
    missionTime,
    inForce,
    mode,
    kappa: 1,
    row: { north: 0, east: 0, depth },
  });
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

  it("draws no line from where a vehicle lay to where its mission begins", () => {
    const { history, say } = told();
    say(0, { phase: MissionPhase.IDLE });
    place(history, 1, { depth: 0, missionTime: 0, inForce: false });
    place(history, 1.05, { depth: 2, missionTime: 0, inForce: false }); // put there; its phase comes later
    place(history, 1.1, { depth: 2, missionTime: 0.05, inForce: true });
    place(history, 30, { depth: 2.3, missionTime: 29, inForce: true });
    place(history, 30.05, { depth: 5, missionTime: 0, inForce: true }); // the next one, out of a hold
    const depth = [...(history.column("depth")?.slice(0, history.length) ?? [])];
    const steps = depth.slice(1).map((value, i) => Math.abs(value - (depth[i] as number)));
    expect(steps.filter((step) => step > 0.5)).toEqual([]);
    expect(depth.filter((value) => Number.isFinite(value))).toEqual([3, 0, 2, 2, 2.3, 5]);
  });

  it("is filled by the past of a new connection without losing what is here", () => {
    const { history, fly } = flown();
    for (const t of [0, 0.25]) fly(t);
    for (const t of [0.1, 0.5]) fly(t, Mode.FORWARD, 0, true);
    expect(times(history)).toEqual([0, 0.25, 0.5]);
  });

  it("keeps what it has when the vehicle's clock steps back, and goes on behind a gap", () => {
    const { history, fly } = flown();
    for (const t of [10, 10.25, 1, 1.25]) fly(t);
    expect(times(history)).toEqual([10, 10.25, 10.26, 11.25, 11.5]);
    expect(history.column("depth")?.[2]).toBeNaN();
    expect(history.last() - history.missionStart).toBeCloseTo(1.25, 6);
  });

  it("takes no row for the whole of a gap before it", () => {
    const { history, fly } = flown();
    for (const t of [0, 0.25, 20, 20.25]) fly(t);
    expect([0, 1, 2, 3, 4].map((i) => Math.round(history.stretch(i) * 100) / 100)).toEqual([
      0, 0.25, 0.01, 0, 0.25,
    ]);
  });

  it("knows what a ramp comes from: after a pause from hover, not from the mode before", () => {
    const { history, say } = told();
    say(0, { mode: Mode.REVERSE, flown: Mode.REVERSE, kappa: 1 });
    expect(history.rampFrom).toBe(Mode.UNSPECIFIED);
    say(0.25, { mode: Mode.REVERSE, flown: Mode.HOVER, kappa: 0.1, phase: MissionPhase.PAUSED });
    expect(history.rampFrom).toBe(Mode.REVERSE);
    say(0.5, { mode: Mode.REVERSE, flown: Mode.HOVER, kappa: 1, phase: MissionPhase.PAUSED });
    say(0.75, { mode: Mode.REVERSE, flown: Mode.REVERSE, kappa: 0.1 });
    expect(history.rampFrom).toBe(Mode.HOVER);
    say(1, { mode: Mode.REVERSE, flown: Mode.REVERSE, kappa: 1 });
    say(1.25, { mode: Mode.REVERSE, flown: Mode.REVERSE, kappa: 0.1 });
    expect(history.rampFrom).toBe(Mode.REVERSE);
  });

  it("takes no reference, range or detection from a control that is not in force", () => {
    const { history, say } = told();
    say(0, { mode: Mode.REVERSE, rangeM: 5, detection: true });
    say(0.25, { mode: Mode.REVERSE, rangeM: 5, detection: true, phase: MissionPhase.ABORTED });
    expect([...(history.column("range")?.slice(0, 2) ?? [])]).toEqual([5, Number.NaN]);
    expect(history.column("detection")?.[1]).toBeNaN();
    expect(history.column("depth")?.[1]).toBe(3);
    expect([...history.mode.slice(0, 2)]).toEqual([Mode.REVERSE, Mode.UNSPECIFIED]);
  });

  it("shows hover while station is held: in a pause and after the mission", () => {
    const { history, say } = told();
    say(0, { mode: Mode.FORWARD, phase: MissionPhase.PAUSED });
    say(0.25, { mode: Mode.FORWARD, flown: Mode.HOVER, phase: MissionPhase.COMPLETED });
    expect([...history.mode.slice(0, 2)]).toEqual([Mode.HOVER, Mode.HOVER]);
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
