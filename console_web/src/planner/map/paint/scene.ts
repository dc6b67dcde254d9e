// What the plan from above shows, and where a place of the water is on the canvas.
import type { Held } from "../../../lib/held";
import type { Drawn } from "../../charts/charts";
import type { Flight, Nominal } from "../../fly/foresight";
import type { Origin } from "../../model/earth";
import type { Ned } from "../../model/geometry";
import type { MissionView, Outline } from "../../model/mission";
import type { Figures } from "../figures";
import { type Px, type Size, toPx, type Viewport } from "../viewport";

export interface Scene {
  view: MissionView;
  viewport: Viewport;
  size: Size;
  selected: readonly string[];
  hovered: string | undefined;
  figures: Figures | undefined;
  nominal: Nominal | undefined;
  flights: readonly Flight[];
  picked: Flight | undefined;
  /** The way of the what-if variant. */
  variant: Nominal | undefined;
  /** Which headings hold station in the planned current, and in the one that the vehicle estimates. */
  held: Held | undefined;
  heldNow: Held | undefined;
  /** The forecast is of an older text. */
  stale: boolean;
  vehicle: { north: number; east: number; heading: number } | undefined;
  box: readonly [number, number, number, number] | undefined;
  /** Charts beneath the plan, the lowest first. */
  charts: readonly Drawn[];
  theme: string;
  /** A base map, where an address of tiles and an origin are there. */
  tiles: { address: string; attribution: string; origin: Origin } | undefined;
  /** Corners of the outline that is being drawn. */
  drawn: Outline;
  /** The waves' dial is shown though there are none. */
  waving: boolean;
  measured: readonly (readonly [number, number])[];
  cursor: readonly [number, number] | undefined;
}

export type Ctx = CanvasRenderingContext2D;
export const TAU = 2 * Math.PI;

export function px(s: Scene, [n, e]: Ned | readonly [number, number]): Px {
  return toPx(s.viewport, s.size, e as number, n as number);
}

/** Angle on the canvas of a heading. */
export function angle(s: Scene, heading: number): number {
  return ((heading - 90) * Math.PI) / 180 - s.viewport.turn;
}
