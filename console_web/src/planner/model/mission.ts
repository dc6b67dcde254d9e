// What views need of a mission, read leniently: half-written text must not blank the screen.

import type { EventKind } from "./event_kinds";
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

/** A place in the plane. */
export type Point = readonly [north: number, east: number];
export type Outline = readonly Point[];
export interface Zone {
  name: string;
  corners: Outline;
  from: number;
  /** Undefined: down to the bottom. */
  to: number | undefined;
}
export interface Wave {
  height: number;
  period: number;
  /** Heading towards which it travels. */
  direction: number;
}
/** A time in which something fails; `to` undefined: from then on. */
export interface PlanEvent {
  from: number;
  to: number | undefined;
  /** The actuator of a fault. */
  of: string;
  /** What is left of it, 0 to 1. */
  left: number;
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
  wave: Wave | undefined;
  /** Depth of the bottom; 0: none given. */
  waterDepth: number;
  keepOut: Zone[];
  keepIn: Outline | undefined;
  events: Record<EventKind, PlanEvent[]>;
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

function list(value: unknown): Table[] {
  return (Array.isArray(value) ? (value as unknown[]) : []).map(table);
}

function outlineOf(value: unknown): Outline {
  return list(value).map((corner) => [number(corner.north_m, 0), number(corner.east_m, 0)] as const);
}

function zoneOf(zone: Table): Zone {
  const to = zone.to_depth_m;
  return {
    name: text(zone.name),
    corners: outlineOf(zone.corners),
    from: number(zone.from_depth_m, 0),
    to: typeof to === "number" ? to : undefined,
  };
}

function waveOf(value: unknown): Wave | undefined {
  if (value === undefined || value === null) return undefined;
  const wave = table(value);
  return {
    height: number(wave.height_m, 0),
    period: number(wave.period_s, 0),
    direction: number(wave.direction_deg, 0),
  };
}

function outageOf(outage: Table): PlanEvent {
  return { from: number(outage.from_s, 0), to: number(outage.to_s, 0), of: "", left: 0 };
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
  const environment = table(top.environment);
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
    current: place(environment.current_ned_mps) ?? [0, 0, 0],
    wave: waveOf(environment.wave),
    waterDepth: number(environment.water_depth_m, 0),
    keepOut: list(top.keep_out).map(zoneOf),
    keepIn:
      top.keep_in === undefined || top.keep_in === null ? undefined : outlineOf(table(top.keep_in).corners),
    events: {
      fault: list(top.faults).map((fault) => ({
        from: number(fault.at_s, 0),
        to: undefined,
        of: text(fault.actuator),
        left: number(fault.effectiveness, 1),
      })),
      outage: list(table(top.sensors).outages).map(outageOf),
      dvl: list(table(top.sensors).dvl_outages).map(outageOf),
    },
    parameters: top.parameters,
    raw,
  };
}

/** Value at a path of a plain tree. */
export function valueAt(raw: unknown, path: readonly (string | number)[]): unknown {
  return path.reduce<unknown>((inner, key) => (inner as Table | undefined | null)?.[key as string], raw);
}
