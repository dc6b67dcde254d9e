// JSON that the server answers with. Names and units as in the HTTP contract.
import type { Problem } from "./http";

export interface VehicleInfo {
  id: string;
  name: string;
  controllable?: string[];
  control_period_s?: number;
  actuators?: { name: string; kind: string; unit: string; min?: number; max?: number }[];
}

export interface MissionSummary {
  name: string;
  title?: string;
  summary?: string;
  duration_s?: number | null;
  sha256?: string;
  builtin?: boolean;
  /** False: the stored file breaks a rule and cannot be started. */
  valid?: boolean;
  problems?: Problem[];
  modified?: string | number;
}

export interface MissionDetail extends MissionSummary {
  yaml: string;
  /** Waypoints, the start first; [north, east, down] in m. */
  path_ned_m?: number[][];
  target?: { position_ned_m: number[]; heading_deg: number; observation_point_ned_m: number[] };
  current_ned_mps?: number[];
}

export interface CommandReply {
  accepted: boolean;
  reason: string;
  run_id?: string;
  revision?: number | string;
}

export interface Range {
  path: string;
  unit: string;
  min: number;
  max: number;
  label?: string;
}

export interface ParametersAnswer {
  active: unknown;
  defaults: unknown;
  revision: number;
  ranges: Range[];
}

export interface RunSummary {
  id: string;
  mission: string;
  started: string | number;
  duration_s?: number | null;
  bytes: number;
  state: "recording" | "complete" | "interrupted";
  end_reason?: string;
  metrics?: unknown;
}
