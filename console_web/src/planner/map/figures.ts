// Thresholds, sight and approach of the mission's vehicle, with what the mission itself overrides.
import { computed, signal } from "@preact/signals";
import { ask } from "../../api/client";
import type { components } from "../../gen/api";
import { valueAt } from "../model/mission";
import { mission } from "../model/plan";

type Planning = components["schemas"]["Planning"];

export interface Figures {
  sight: number;
  halfAngle: number;
  thresholds: { rh: number; fr: number };
  /** The vehicle docks by itself. */
  docks: boolean;
  entry: number;
  keepOut: number;
  cone: { base: number; slope: number };
}

const known = signal<ReadonlyMap<string, Planning | undefined>>(new Map());
export const vehicles = signal<readonly string[]>([]);

/** Ask for a vehicle once; again when another build of it speaks on the bus. */
export async function learn(id: string): Promise<void> {
  if (!id || known.peek().has(id)) return;
  known.value = new Map(known.peek()).set(id, undefined);
  const answer = await ask("get", "/api/planning/{vehicle}", { path: { vehicle: id } });
  if (answer.ok) known.value = new Map(known.peek()).set(id, answer.value);
}

export async function learnVehicles(): Promise<void> {
  if (vehicles.peek().length > 0) return;
  const answer = await ask("get", "/api/planning");
  if (answer.ok) vehicles.value = answer.value;
}

export const vehicle = computed(() => known.value.get(mission.value.vehicle));

export const figures = computed<Figures | undefined>(() => {
  const own = vehicle.value;
  if (!own) return undefined;
  const raw = mission.value.raw;
  const set = (path: string[], otherwise: number): number => {
    const value = valueAt(raw, path);
    return typeof value === "number" ? value : otherwise;
  };
  const { approach, sight, thresholds_m: ranges } = own;
  const enabled = valueAt(raw, ["parameters", "docking", "enabled"]);
  return {
    sight: set(["sensors", "detection", "range_max_m"], sight.range_max_m),
    halfAngle: set(["sensors", "detection", "field_of_view_half_deg"], sight.half_angle_deg),
    thresholds: {
      rh: set(["parameters", "supervisor", "range_rh_lower_m"], ranges.range_rh_lower_m ?? 0),
      fr: set(["parameters", "supervisor", "range_fr_lower_m"], ranges.range_fr_lower_m ?? 0),
    },
    docks: typeof enabled === "boolean" ? enabled : approach.enabled,
    entry: set(["parameters", "docking", "entry_distance_m"], approach.entry_distance_m),
    keepOut: set(["parameters", "docking", "keep_out_m"], approach.keep_out_m),
    cone: {
      base: set(["parameters", "docking", "cone_base_m"], approach.cone_base_m),
      slope: set(["parameters", "docking", "cone_slope"], approach.cone_slope),
    },
  };
});
