// Where ghosts come from: a recorded run's frames, or the mission flown ahead. Loaded when one is chosen.

import { rowsOfRun } from "../compare/compared";
import { Foresight } from "../planner/fly/foresight";
import { screen } from "../stream/screen";

export interface Flown {
  /** Mission time of each row, s, ascending. */
  time: number[];
  columns: Record<string, (number | null)[]>;
}

export async function earlierRun(id: string): Promise<Flown> {
  const rows = ((await rowsOfRun(id)) ?? []).filter(({ inForce }) => inForce);
  if (!rows.length) throw new Error("this run cannot be replayed");
  const names = [...new Set(rows.flatMap(({ row }) => Object.keys(row)))];
  const columns = Object.fromEntries(names.map((name) => [name, rows.map(({ row }) => row[name] ?? null)]));
  return { time: rows.map(({ missionTime }) => missionTime), columns };
}

export function forecast(): Promise<Flown> {
  const text = screen.latest("tlm/plan")?.missionYaml;
  if (!text) return Promise.reject(new Error("the vehicle has told no mission"));
  const asked = new Foresight();
  return new Promise<Flown>((found, lost) => {
    const stop = asked.shown.subscribe((told) => {
      if (!told) return;
      const track = told.nominal?.track;
      if (!track && told.state === "flying") return;
      queueMicrotask(() => {
        stop();
        asked.close();
      });
      if (!track) return lost(new Error(told.reason || "the mission cannot be flown ahead"));
      found({
        time: track.t_s,
        columns: {
          depth: track.depth_m,
          yaw: track.heading_deg,
          speed: track.speed_m_s,
          north: track.north_m,
          east: track.east_m,
        },
      });
    });
    asked.open();
    asked.ask({ text, flights: 0 });
  });
}
