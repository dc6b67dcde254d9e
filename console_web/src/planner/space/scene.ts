// What the plan in space shows.

import type { Held } from "../../lib/held";
import type { ChartShown } from "../charts/charts";
import type { Flight, Nominal } from "../fly/foresight";
import type { Figures } from "../map/figures";
import type { Size } from "../map/viewport";
import type { Ned } from "../model/geometry";
import { type MissionView, table } from "../model/mission";
import { outlines, outlineThing } from "../model/things";
import { outlinePlace } from "../model/zones";
import type { Lens } from "./orbit";

export interface SpaceScene {
  view: MissionView;
  lens: Lens;
  size: Size;
  selected: readonly string[];
  hovered: string | undefined;
  nominal: Nominal | undefined;
  variant: Nominal | undefined;
  flights: readonly Flight[];
  picked: Flight | undefined;
  stale: boolean;
  held: Held | undefined;
  heldNow: Held | undefined;
  vehicle: { at: Ned; heading: number } | undefined;
  /** The depth grid that is looked at. */
  depths: ChartShown | undefined;
  /** Sight and approach of the vehicle; undefined until it is known. */
  figures: Figures | undefined;
  /** Length of the vehicle, m. */
  length: number;
}

/** Depth of the floor that is drawn: the water's, or below all that is planned. */
export function floorOf({ waterDepth, start, legs, dock, keepOut }: MissionView): number {
  if (waterDepth > 0) return waterDepth;
  const depths = [start.at[2], ...legs.map(({ at }) => at[2]), dock?.at[2] ?? 0];
  const zones = keepOut.map(({ to }) => to ?? 0).filter((to) => to < 1000);
  return Math.max(2, ...depths, ...zones) * 1.25;
}

/** Everything that has a place, for a first look. */
export function placesOf(view: MissionView): Ned[] {
  const places: Ned[] = [view.start.at, ...view.legs.map(({ at }) => at)];
  if (view.dock) places.push(view.dock.at);
  for (const { corners } of view.keepOut)
    places.push(...corners.map(([n, e]): Ned => [n, e, view.start.at[2]]));
  return places;
}

/** What can be taken hold of: points, and the outlines' middles. */
export function pointsOf(view: MissionView): { thing: string; at: Ned }[] {
  const found = [{ thing: "start", at: view.start.at }];
  view.legs.forEach(({ at }, i) => {
    found.push({ thing: `leg:${i}`, at });
  });
  if (view.dock) found.push({ thing: "dock", at: view.dock.at });
  for (const which of outlines(view)) {
    const thing = outlineThing(which);
    const at = outlinePlace(view, thing);
    if (at && which !== "in") found.push({ thing, at });
  }
  return found;
}

/** Width and length of the dock as the mission has them. */
export function dockSize(view: MissionView): { width: number; length: number } {
  const target = table(table(view.raw).target);
  const number = (value: unknown, otherwise: number): number =>
    typeof value === "number" ? value : otherwise;
  return { width: number(target.dock_width_m, 2), length: number(target.dock_length_m, 1.5) };
}
