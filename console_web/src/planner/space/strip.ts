// The strip of the approach, as places.
import type { Figures } from "../map/figures";
import { along, type Ned } from "../model/geometry";

/** Corners of the approach, level: at the observation point as wide as its base, wider the farther off. */
export function approachStrip(at: Ned, heading: number, figures: Figures): Ned[] {
  const side = (left: number, sign: number): Ned =>
    along(along(at, heading, -left), heading + 90 * sign, figures.cone.base + figures.cone.slope * left);
  return [side(0, 1), side(figures.entry, 1), side(figures.entry, -1), side(0, -1)];
}
