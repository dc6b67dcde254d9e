// What is plotted: groups of small plots, each a measured line and its reference.
import { controllableAxes } from "../lib/vehicle";
import { axisUnit } from "../lib/wrench";
import { screen } from "../stream/screen";

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
  /** The axis spans at least this much. */
  smallestSpan: number;
}

export const GROUPS = ["Motion", "Attitude", "Wrench", "Actuators"] as const;
export type Group = (typeof GROUPS)[number];

function pair(id: string, title: string, unit: string, decimals: number, smallestSpan: number): PlotSpec {
  const traces: Trace[] = [
    { column: `${id}_reference`, name: "reference", look: "reference" },
    { column: id, name: "measured", look: "measured" },
  ];
  return { id, title, unit, decimals, smallestSpan, traces };
}

const MOTION: PlotSpec[] = [
  { ...pair("depth", "Depth", "m", 2, 0.4), downward: true },
  pair("speed", "Surge speed", "m/s", 2, 0.2),
  { ...pair("yaw", "Heading", "°", 1, 4), heading: true },
];

const ATTITUDE: PlotSpec[] = [
  { ...pair("yaw", "Heading", "°", 1, 4), heading: true },
  pair("pitch", "Pitch", "°", 1, 4),
  { ...pair("roll", "Roll", "°", 1, 4), traces: [{ column: "roll", name: "measured", look: "measured" }] },
];

export function specsOf(group: Group): PlotSpec[] {
  if (group === "Motion") return MOTION;
  if (group === "Attitude") return ATTITUDE;
  if (group === "Wrench") {
    return controllableAxes().map((axis) => ({
      id: `wrench_${axis}`,
      title: axis,
      unit: axisUnit(axis),
      decimals: 2,
      smallestSpan: 0.1,
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
