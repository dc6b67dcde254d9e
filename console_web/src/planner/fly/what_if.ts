// A variant of the plan beside it: another current, other numbers of the controller, another vehicle.
import { batch, computed, effect, signal } from "@preact/signals";
import { type Edit, edited } from "../model/document";
import type { Ned } from "../model/geometry";
import type { MissionView, PlanEvent } from "../model/mission";
import { setCurrent } from "../model/operations";
import { broken, edit, mission, text } from "../model/plan";
import { EVENT_PATHS } from "../model/things";
import { FLIGHTS, type Forecast, Foresight, type Overrides } from "./foresight";

export interface Change {
  /** "hover.lambda" */
  path: string;
  value: number | undefined;
}

export const line = new Foresight();
/** Current of the variant, NED; undefined: the plan's. */
export const current = signal<readonly [number, number, number] | undefined>(undefined);
export const vehicle = signal("");
export const changes = signal<readonly Change[]>([]);
/** An actuator that fails in the variant; undefined: none but the plan's. */
export const failed = signal<PlanEvent | undefined>(undefined);
export const forecast = computed(() => line.shown.value);

export const overrides = computed<Overrides | undefined>(() => {
  const parameters = Object.fromEntries(
    changes.value.flatMap(({ path, value }) => (value === undefined ? [] : [[path, value]])),
  );
  const other = vehicle.value && vehicle.value !== mission.value.vehicle ? vehicle.value : null;
  if (!current.value && !other && Object.keys(parameters).length === 0) return undefined;
  return { parameters, current: current.value ? [...current.value] : null, vehicle: other };
});

/** Whether anything of the variant differs from the plan. */
export const varied = computed(() => overrides.value !== undefined || failed.value !== undefined);

function faultEdits(view: MissionView): Edit[] {
  const fault = failed.value;
  if (!fault) return [];
  const value = { actuator: fault.of, at_s: fault.from, effectiveness: fault.left };
  return [{ path: [...EVENT_PATHS.fault, view.events.fault.length], value }];
}

/** The plan's text with what the server's overrides have no word for. */
const variantText = computed(() => {
  const edits = faultEdits(mission.value);
  return edits.length > 0 && !broken.value ? edited(text.value, edits) : text.value;
});

/** Make the variant the plan: one step, taken back as one. */
export function adopt(): void {
  const view = mission.peek();
  const edits: Edit[] = [...faultEdits(view)];
  if (current.peek()) edits.push(...setCurrent(view, current.peek() as Ned));
  if (overrides.peek()?.vehicle) edits.push({ path: ["vehicle"], value: vehicle.peek() });
  for (const { path, value } of changes.peek())
    if (value !== undefined) edits.push({ path: ["parameters", ...path.split(".")], value });
  edit("Take the variant", edits);
  batch(() => {
    current.value = undefined;
    failed.value = undefined;
    vehicle.value = "";
    changes.value = [];
  });
}

/** Fly the variant with each change of it or of the plan, while it is looked at. */
export function follow(): () => void {
  line.open();
  const stop = effect(() => {
    const wanted = overrides.value;
    const plan = variantText.value;
    if (varied.value) line.ask({ text: plan, flights: FLIGHTS, ...(wanted ? { overrides: wanted } : {}) });
    else line.clear();
  });
  return () => {
    stop();
    line.close();
    line.clear();
  };
}

export interface Figure {
  name: string;
  unit: string;
  decimals: number;
  of: (forecast: Forecast) => number | undefined;
}

function most(values: readonly number[] | undefined): number | undefined {
  return values?.length ? Math.max(...values.map(Math.abs)) : undefined;
}

function switchTo(mode: string): (forecast: Forecast) => number | undefined {
  return ({ nominal }) => nominal?.switches.find(({ to }) => to === mode)?.t_s;
}

/** What two variants are compared by. */
export const FIGURES: readonly Figure[] = [
  {
    name: "Docks",
    unit: "%",
    decimals: 1,
    of: ({ chance }) => (chance && chance.of > 0 ? (100 * chance.docked) / chance.of : undefined),
  },
  { name: "To reverse", unit: "s", decimals: 1, of: switchTo("R") },
  { name: "In hover", unit: "s", decimals: 1, of: ({ nominal }) => nominal?.arrival_s ?? undefined },
  { name: "Way flown", unit: "m", decimals: 1, of: ({ nominal }) => nominal?.length_m },
  { name: "Energy", unit: "J", decimals: 1, of: ({ nominal }) => nominal?.energy_j },
  { name: "Depth error", unit: "m", decimals: 3, of: ({ nominal }) => most(nominal?.track.depth_error_m) },
  {
    name: "Most used",
    unit: "%",
    decimals: 0,
    of: ({ nominal }) => {
      const load = most(nominal?.track.saturation);
      return load === undefined ? undefined : 100 * load;
    },
  },
];
