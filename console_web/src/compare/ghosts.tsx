// The compared flights in 3-D, each from the moment they are aligned on, moved by one slider.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Data3d } from "../../../twin/bumpless/review/replay3d.js";
import { colour } from "../lib/theme";
import { flightOfRows } from "../replay/replay_scene";
import { hullOf, learnHull, Scene3d } from "../replay/view3d";
import { type Comparison, letterOf, type Moment, rows } from "./compared";

const STEP_S = 0.1;

export function Ghosts({ comparison, align }: { comparison: Comparison; align: Moment }) {
  const time = useSignal(0);
  const aligned = useSignal(align);
  aligned.value = align;
  const runs = useRef(comparison.runs);
  runs.current = comparison.runs;
  useEffect(() => {
    for (const run of comparison.runs) void learnHull(run.id);
  }, [comparison]);
  const ends = rows.value.map((flight, k) => {
    const zero = zeroOf(comparison.runs[k], align);
    return [(flight[0]?.missionTime ?? 0) - zero, (flight.at(-1)?.missionTime ?? 0) - zero] as const;
  });
  const [first, last] = [Math.min(0, ...ends.map(([a]) => a)), Math.max(0, ...ends.map(([, b]) => b))];
  return (
    <div class="ghosts">
      <Scene3d
        title="Flights in 3-D"
        preset="overview"
        data={() => dataOf(runs.current, aligned.value)}
        time={() => time.value}
      />
      <label class="ghosts-time" hidden={last <= first}>
        <span class="num">{time.value.toFixed(1)} s</span>
        <input
          type="range"
          aria-label="Seconds from the moment the runs are aligned on"
          min={first}
          max={last}
          step={STEP_S}
          value={time.value}
          onInput={(event) => {
            time.value = Number(event.currentTarget.value);
          }}
        />
      </label>
    </div>
  );
}

type Run = Comparison["runs"][number];

function zeroOf(run: Run | undefined, align: Moment): number {
  return (run?.moments as Record<string, number> | undefined)?.[align] ?? 0;
}

function dataOf(runs: readonly Run[], align: Moment): Data3d {
  const flights = rows.value.map((own, k) => ({
    ...flightOfRows(own),
    name: letterOf(k),
    colour: colour(`--run-${k + 1}`),
    zero: zeroOf(runs[k], align),
    hull: hullOf(runs[k]?.id ?? ""),
  }));
  return { flights: flights.filter(({ position }) => position.length > 0) };
}
