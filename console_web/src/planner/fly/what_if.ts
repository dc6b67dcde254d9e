// A variant of the plan beside it: another current, other numbers of the controller, another vehicle.
import { computed, effect, signal } from "@preact/signals";
import { mission, text } from "../model/plan";
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
export const forecast = computed(() => line.shown.value);

export const overrides = computed<Overrides | undefined>(() => {
  const parameters = Object.fromEntries(
    changes.value.flatMap(({ path, value }) => (value === undefined ? [] : [[path, value]])),
  );
  const other = vehicle.value && vehicle.value !== mission.value.vehicle ? vehicle.value : null;
  if (!current.value && !other && Object.keys(parameters).length === 0) return undefined;
  return { parameters, current: current.value ? [...current.value] : null, vehicle: other };
});

/** Fly the variant with each change of it or of the plan, while it is looked at. */
export function follow(): () => void {
  line.open();
  const stop = effect(() => {
    const wanted = overrides.value;
    const plan = text.value;
    if (wanted) line.ask({ text: plan, flights: FLIGHTS, overrides: wanted });
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
