// The columns that the list can show beside outcome and title.
import type { RunSummary } from "../api/types";
import type { components } from "../gen/api";
import { bytes, clock, dateTime, fixed } from "../lib/format";
import { asOne, type Flight } from "./flights";

export type Column = components["schemas"]["RunViewAnswer"]["columns"][number];

interface About {
  name: string;
  about: string;
  num: boolean;
  of: (flight: Flight) => string;
  /** Said in full where the cell shows a part of it. */
  whole?: (flight: Flight) => string;
}

type Figure = number | null | undefined;
const known = (values: Figure[]): number[] => values.filter((value): value is number => value != null);
const least = (values: Figure[]): Figure => (known(values).length ? Math.min(...known(values)) : null);
const most = (values: Figure[]): Figure => (known(values).length ? Math.max(...known(values)) : null);

function errorsOf(metrics: RunSummary["metrics"]): Figure[] {
  return (metrics?.modes ?? []).flatMap((mode) => [mode.depth_error_max_m, mode.cross_track_error_max_m]);
}

/** What a flight with gaps was at least, or at most: what nobody recorded may have been more. */
function bounded(sign: "≥" | "≤", flight: Flight, value: Figure, decimals: number): string {
  const whole = flight.flown.length < 2 && (!flight.growing || flight.holds);
  return value == null || whole ? fixed(value, decimals) : `${sign} ${fixed(value, decimals)}`;
}

export const COLUMNS: Record<Column, About> = {
  recorded: {
    name: "Recorded",
    about: "When its last file was written, by the server's clock",
    num: true,
    of: (flight) => dateTime(asOne(flight).recorded).replace(/:\d\d(?= \S+$)/, ""),
    whole: (flight) => dateTime(asOne(flight).recorded),
  },
  duration: {
    name: "Duration",
    about: "Mission time at its end",
    num: true,
    of: (flight) => clock(asOne(flight).duration_s),
  },
  closest: {
    name: "Closest, m",
    about: "Least distance of the hull's axis from the marker, in what was recorded",
    num: true,
    of: (flight) =>
      bounded("≤", flight, least(flight.flown.map(({ metrics }) => metrics?.outcome?.closest_m)), 2),
  },
  error: {
    name: "Worst error, m",
    about: "Largest error of depth or cross-track about their references, as believed",
    num: true,
    of: (flight) => bounded("≥", flight, most(flight.flown.flatMap(({ metrics }) => errorsOf(metrics))), 2),
  },
  steps: {
    name: "Steps",
    about: "Largest d_u of F→R and R→H: commands over their bounds, within 2 s of the switch",
    num: true,
    of: (flight) =>
      bounded(
        "≥",
        flight,
        most(flight.flown.flatMap(({ metrics }) => [metrics?.d_u_fr, metrics?.d_u_rh])),
        3,
      ),
  },
  seed: {
    name: "Seed",
    about: "Of every random number of a simulated flight",
    num: true,
    of: ({ head }) => String(head.seed),
  },
  revision: {
    name: "Revision",
    about: "The first digits of the parameters' hash: the same digits, the same parameters",
    num: false,
    of: ({ head }) => head.parameters_sha256.slice(0, 7) || "–",
    whole: ({ head }) =>
      `parameters ${head.parameters_sha256 || "not told"}, mission ${head.mission_sha256 || "not told"}, ` +
      `software ${head.software_version || "not told"}`,
  },
  vehicle: { name: "Vehicle", about: "Who flew it", num: false, of: ({ head }) => head.vehicle || "–" },
  note: {
    name: "Note",
    about: "What was written about it",
    num: false,
    of: ({ head }) => head.note,
    whole: ({ head }) => head.note,
  },
  size: { name: "Size", about: "Of all its files", num: true, of: (flight) => bytes(asOne(flight).bytes) },
};
export const ALL = Object.keys(COLUMNS) as Column[];
export const USUAL: readonly Column[] = ["recorded", "duration", "closest", "steps"];
