// What is plotted: groups of small plots, each a measured line and its reference.
import { controllableAxes } from "../lib/vehicle";
import { axisUnit } from "../lib/wrench";
import { screen } from "../stream/screen";
import { reachOf } from "./reach";

export interface Trace {
  column: string;
  name: string;
  look: "measured" | "reference";
}

export interface PlotSpec {
  id: string;
  title: string;
  unit: string;
  decimals: number;
  traces: Trace[];
  /** Depth grows downwards. */
  downward?: boolean;
  /** Labels modulo 360. */
  heading?: boolean;
  /** The axis spans at least this much: noise alone never fills a plot. */
  smallestSpan: number;
  /** The limit of the alarms that the first trace is watched against: drawn as a band about the reference. */
  limit?: LimitName;
}

/** Errors that are watched, by the limits' own names. */
export type LimitName = "depth_m" | "heading_deg" | "speed_mps" | "cross_track_m";

export const GROUPS = ["Motion", "Attitude", "Wrench", "Actuators", "Own"] as const;
export type Group = (typeof GROUPS)[number];

function pair(id: string, title: string, unit: string, decimals: number, smallestSpan: number): PlotSpec {
  const traces: Trace[] = [
    { column: `${id}_reference`, name: "reference", look: "reference" },
    { column: id, name: "measured", look: "measured" },
  ];
  return { id, title, unit, decimals, smallestSpan, traces };
}

function alone(id: string, title: string, unit: string, decimals: number, smallestSpan: number): PlotSpec {
  const traces: Trace[] = [{ column: id, name: "measured", look: "measured" }];
  return { id, title, unit, decimals, smallestSpan, traces };
}

const MOTION: PlotSpec[] = [
  { ...pair("depth", "Depth", "m", 2, 0.4), downward: true, limit: "depth_m" },
  { ...pair("speed", "Surge speed", "m/s", 2, 0.2), limit: "speed_mps" },
  { ...pair("yaw", "Heading", "°", 1, 4), heading: true, limit: "heading_deg" },
];

const ATTITUDE: PlotSpec[] = [
  { ...pair("yaw", "Heading", "°", 1, 4), heading: true, limit: "heading_deg" },
  pair("pitch", "Pitch", "°", 1, 4),
  alone("roll", "Roll", "°", 1, 4),
];

/** What stands in no group of its own. */
const OTHERS: PlotSpec[] = [
  alone("range", "Range", "m", 2, 1),
  { ...alone("cross_track", "Cross-track error", "m", 2, 0.4), limit: "cross_track_m" },
  alone("north", "North", "m", 1, 2),
  alone("east", "East", "m", 1, 2),
  alone("kappa", "Transition factor κ", "", 2, 1),
  alone("detection_raw", "Raw detection", "", 0, 1.2),
  alone("detection", "Filtered detection", "", 0, 1.2),
  alone("residual", "Residual norm", "", 3, 0.05),
  alone("solve_time", "Solve time", "µs", 0, 50),
];

export function specsOf(group: Exclude<Group, "Own">): PlotSpec[] {
  if (group === "Motion") return MOTION;
  if (group === "Attitude") return ATTITUDE;
  if (group === "Wrench") {
    return controllableAxes().map((axis) => ({
      id: `wrench_${axis}`,
      title: axis,
      unit: axisUnit(axis),
      decimals: 2,
      smallestSpan: Math.max(0.1, 0.1 * reachOf(axis)),
      traces: [
        { column: `demanded_${axis}`, name: "demanded", look: "reference" },
        { column: `achieved_${axis}`, name: "achieved", look: "measured" },
      ],
    }));
  }
  return (screen.latest("tlm/actuators")?.actuators ?? []).map(({ name, unit }) => ({
    id: `actuator_${name}`,
    title: name,
    unit: unit === "deg" ? "°" : unit,
    decimals: unit === "deg" ? 1 : 0,
    smallestSpan: unit === "deg" ? 2 : 10,
    traces: [
      { column: `command_${name}`, name: "command", look: "reference" },
      { column: `feedback_${name}`, name: "feedback", look: "measured" },
    ],
  }));
}

/** Every signal that can be plotted, each once. */
export function everySpec(): PlotSpec[] {
  const all = [MOTION, ATTITUDE, OTHERS, specsOf("Wrench"), specsOf("Actuators")].flat();
  return [...new Map(all.map((spec) => [spec.id, spec])).values()];
}
