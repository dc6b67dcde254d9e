// The replayed state in 3-D: what was flown up to the playhead, the hull at it, the plan and the target.
import { untracked } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Data3d, Flight3d } from "../../../twin/bumpless/review/replay3d.js";
import { Mode } from "../gen/bumpless_pb";
import { modeLook } from "../lib/modes";
import type { CycleRow } from "../stream/cycle_row";
import type { History } from "../stream/history";
import { screen } from "../stream/screen";
import type { Replay } from "./replay";
import { hullOf, learnHull, Scene3d } from "./view3d";

const POSE = ["north", "east", "depth", "roll", "pitch", "yaw"] as const;

/** A flight out of the replay's rows. */
export function flightOfHistory(history: History): Flight3d {
  const flight: Flight3d = { time: [], position: [], attitude: [], mode: [] };
  const columns = POSE.map((name) => history.column(name));
  const time: number[] = [];
  for (let i = 0; i < history.length; i++) {
    const values = columns.map((column) => column?.[i] ?? Number.NaN);
    if (!values.every(Number.isFinite)) continue;
    time.push((history.time[i] as number) - history.missionStart);
    flight.position.push(values.slice(0, 3));
    flight.attitude.push(values.slice(3));
    flight.mode?.push(letterOf(history.mode[i] as Mode));
  }
  return { ...flight, time };
}

/** A flight out of a compared run's rows, in its own colour and time. */
export function flightOfRows(rows: readonly CycleRow[]): Flight3d {
  const flight: Flight3d = { time: [], position: [], attitude: [], mode: [] };
  const time: number[] = [];
  for (const { missionTime, inForce, mode, row } of rows) {
    const values = POSE.map((name) => row[name] ?? Number.NaN);
    if (!inForce || !values.every(Number.isFinite)) continue;
    time.push(missionTime);
    flight.position.push(values.slice(0, 3));
    flight.attitude.push(values.slice(3));
    flight.mode?.push(letterOf(mode));
  }
  return { ...flight, time };
}

function letterOf(mode: Mode): string {
  return mode === Mode.UNSPECIFIED ? "" : modeLook(mode).letter;
}

export function ReplayScene({ replay }: { replay: Replay }) {
  useEffect(() => void learnHull(replay.run), [replay.run]);
  return (
    <Scene3d
      title="Scene"
      preset="follow"
      class="scene"
      data={() => dataOf(replay)}
      time={() => replay.t.value}
    />
  );
}

function dataOf(replay: Replay): Data3d {
  void [replay.plotted.value, hullOf(replay.run)];
  return untracked(() => known(replay));
}

function known(replay: Replay): Data3d {
  const flight = flightOfHistory(replay.history);
  const target = screen.latest("tlm/target");
  const path = screen.latest("tlm/plan")?.pathNedM.map(({ x, y, z }) => [x, y, z]);
  const [at, station] = [target?.positionNedM, target?.observationPointNedM];
  return {
    flights: flight.position.length ? [flight] : [],
    hull: hullOf(replay.run),
    path,
    target: at && {
      position: [at.x, at.y, at.z],
      heading: target?.headingDeg ?? 0,
      station: station && [station.x, station.y, station.z],
    },
  };
}
