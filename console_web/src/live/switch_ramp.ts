// What the history and the parameters tell of one switch: κ, the weights that went with it, the largest step.
import type { Event, ModeParameters, Parameters } from "../gen/bumpless_pb";
import { screen } from "../stream/screen";

/** Of the paper's window about a switch, s. */
const WINDOW_S = 2;
const BEFORE_S = 0.5;
const LONGEST_S = 6;

type Points = [time: number, share: number][];

export interface Ramp {
  from: number;
  to: number;
  kappa: Points;
  /** Of the components whose weight changes, each over the larger of its two ends. */
  weights: { axis: number; points: Points }[];
}

const modeOf = (of: Parameters | undefined, name: string | undefined): ModeParameters | undefined =>
  name === "forward" || name === "reverse" || name === "hover" ? of?.[name] : undefined;

/** Undefined when the history does not reach back to it. */
export function rampOf(event: Event): Ramp | undefined {
  const at = Number(event.stamp?.timeNs ?? 0n) / 1e9;
  const { history } = screen;
  const column = history.column("kappa");
  if (!column || !(history.first() <= at)) return undefined;
  const kappa: Points = [];
  for (let i = history.firstIndex(at - BEFORE_S); i < history.length; i++) {
    const time = history.time[i] as number;
    if (time > at + LONGEST_S) break;
    const value = column[i] as number;
    if (Number.isNaN(value)) continue;
    kappa.push([time, time < at ? 1 : value]);
    if (time > at + BEFORE_S && value >= 1) break;
  }
  const [first, last] = [kappa[0], kappa.at(-1)];
  if (!first || !last || last[0] <= at) return undefined;
  return { from: first[0], to: last[0], kappa, weights: weightsOf(event, at, kappa) };
}

/** Source: eq. (54): the weights are blended with κ as the demand is. */
function weightsOf(event: Event, at: number, kappa: Points): Ramp["weights"] {
  const active = screen.latest("tlm/parameters")?.active;
  const before = modeOf(active, event.details.from)?.qDiagonal ?? [];
  const after = modeOf(active, event.details.to)?.qDiagonal ?? [];
  return after.flatMap((end, axis) => {
    const start = before[axis] ?? end;
    const most = Math.max(start, end);
    if (start === end || most <= 0) return [];
    const points: Points = kappa.map(([t, k]) => [t, (t < at ? start : k * end + (1 - k) * start) / most]);
    return [{ axis, points }];
  });
}

/** Largest step of the commands over their bounds in one cycle within the window; NaN where it is not known. */
export function commandStep(at: number): number {
  const { history } = screen;
  const actuators = screen.latest("tlm/actuators")?.actuators ?? [];
  const used = actuators.flatMap(({ name, amplitudeLower, amplitudeUpper }) => {
    const column = history.column(`command_${name}`);
    const bound = Math.max(Math.abs(amplitudeLower), Math.abs(amplitudeUpper));
    return column && bound > 0 ? [{ column, bound }] : [];
  });
  let most = Number.NaN;
  if (!used.length || !(history.first() <= at - WINDOW_S)) return most;
  for (let i = Math.max(1, history.firstIndex(at - WINDOW_S)); i < history.length; i++) {
    if ((history.time[i] as number) > at + WINDOW_S) break;
    let square = 0;
    for (const { column, bound } of used)
      square += (((column[i] as number) - (column[i - 1] as number)) / bound) ** 2;
    if (!Number.isNaN(square)) most = Math.max(Number.isNaN(most) ? 0 : most, Math.sqrt(square));
  }
  return most;
}
