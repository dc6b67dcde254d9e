// What views need of a mission, read leniently: half-written text must not blank the screen.
import { bearing, type Ned, turn, wrapped } from "./geometry";

/** Slower water has no direction worth turning into. */
const STILL_MPS = 0.01;

export interface Leg {
  at: Ned;
  speed: number;
}
export interface Start {
  at: Ned;
  heading: number;
  speed: number;
}
export interface Dock {
  at: Ned;
  heading: number;
  standoff: number;
  tolerance: number;
  intoCurrent: boolean;
}
/** The heading it will come in with: the dock's own, or against the current where it is left to the vehicle. */
export function approachOf(dock: Dock, current: Ned): number {
  const free = dock.intoCurrent ? 180 : dock.tolerance;
  if (free === 0 || Math.hypot(current[0], current[1]) < STILL_MPS) return dock.heading;
  const off = turn(dock.heading, wrapped(bearing([0, 0, 0], current) + 180));
  return wrapped(dock.heading + Math.max(-free, Math.min(free, off)));
}

export interface Fault {
  actuator: string;
  at: number;
  effectiveness: number;
}
export interface MissionView {
  name: string;
  title: string;
  vehicle: string;
  duration: number;
  seed: number;
  start: Start;
  /** A leg whose place can't be read lies where the one before ends. */
  legs: Leg[];
  dock: Dock | undefined;
  current: Ned;
  faults: Fault[];
  /** As written: overrides of parameters, and the whole for forms. */
  parameters: unknown;
  raw: unknown;
}

type Table = Record<string, unknown>;

export function table(value: unknown): Table {
  return value !== null && typeof value === "object" && !Array.isArray(value) ? (value as Table) : {};
}

function number(value: unknown, otherwise: number): number {
  return typeof value === "number" && Number.isFinite(value) ? value : otherwise;
}

function text(value: unknown): string {
  return typeof value === "string" ? value : typeof value === "number" ? String(value) : "";
}

function place(value: unknown): Ned | undefined {
  if (!Array.isArray(value) || value.length < 3) return undefined;
  const [n, e, d] = value as unknown[];
  if (![n, e, d].every((v) => typeof v === "number" && Number.isFinite(v))) return undefined;
  return [n as number, e as number, d as number];
}

export function missionView(raw: unknown): MissionView {
  const top = table(raw);
  const start = table(top.start);
  const from = place(start.position_ned_m) ?? [0, 0, 0];
  const legs: Leg[] = [];
  for (const entry of Array.isArray(top.legs) ? top.legs : []) {
    const leg = table(entry);
    legs.push({ at: place(leg.to_ned_m) ?? legs.at(-1)?.at ?? from, speed: number(leg.speed_mps, 0) });
  }
  const target = table(top.target);
  const at = place(target.position_ned_m);
  return {
    name: text(top.name),
    title: text(top.title),
    vehicle: text(top.vehicle),
    duration: number(top.duration_s, 0),
    seed: number(top.seed, 0),
    start: { at: from, heading: number(start.heading_deg, 0), speed: number(start.speed_mps, 0) },
    legs,
    dock: at && {
      at,
      heading: number(target.heading_deg, 0),
      standoff: number(target.standoff_m, 0),
      tolerance: number(target.heading_tolerance_deg, 0),
      intoCurrent: target.approach === "into_current",
    },
    current: place(table(top.environment).current_ned_mps) ?? [0, 0, 0],
    faults: (Array.isArray(top.faults) ? top.faults : []).map((entry) => {
      const fault = table(entry);
      return {
        actuator: text(fault.actuator),
        at: number(fault.at_s, 0),
        effectiveness: number(fault.effectiveness, 1),
      };
    }),
    parameters: top.parameters,
    raw,
  };
}

/** Value at a path of a plain tree. */
export function valueAt(raw: unknown, path: readonly (string | number)[]): unknown {
  return path.reduce<unknown>((inner, key) => (inner as Table | undefined | null)?.[key as string], raw);
}
