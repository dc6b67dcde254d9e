// Rings round the dock: which headings hold station in the planned current, and in the one that is felt.
import { paintHeld } from "../../../lib/held_ring";
import type { Ned } from "../../model/geometry";
import { type Ctx, px, type Scene } from "./scene";

/** Sizes on the screen, whatever the scale: an instrument, and no place in the water. */
export const RING_PX = 66;
export const OUTER_PX = 80;

export function paintRings(c: Ctx, s: Scene, dock: { at: Ned }): void {
  const [x, y] = px(s, dock.at);
  const ring = { x, y, turn: s.viewport.turn };
  c.globalAlpha = s.stale ? 0.35 : 1;
  if (s.held) paintHeld(c, s.held, { ...ring, radius: RING_PX });
  c.globalAlpha = 1;
  if (s.heldNow) paintHeld(c, s.heldNow, { ...ring, radius: OUTER_PX });
}
