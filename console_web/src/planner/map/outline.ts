// The outline that is being drawn: corner by corner, closed by its first corner, or a rectangle at one drag.
import { effect, signal } from "@preact/signals";
import type { Outline, Point } from "../model/mission";
import { addZone, FEWEST_CORNERS, setFence } from "../model/zones";
import { outlining, tool } from "./tools";

/** Corners so far. */
export const drawn = signal<Outline>([]);
const SMALLEST_M = 0.05; // a rectangle of nothing is a slip

effect(() => {
  if (!outlining.value && drawn.peek().length > 0) drawn.value = [];
});

/** Take the outline as drawn; false: it has too few corners yet. */
export function closeOutline(): boolean {
  if (drawn.peek().length < FEWEST_CORNERS) return false;
  finish(drawn.peek());
  return true;
}

export function rectangle([an, ae]: Point, [bn, be]: Point): void {
  if (Math.abs(an - bn) < SMALLEST_M || Math.abs(ae - be) < SMALLEST_M) return;
  finish([
    [an, ae],
    [bn, ae],
    [bn, be],
    [an, be],
  ]);
}

function finish(corners: Outline): void {
  if (tool.peek() === "keep-in") setFence(corners);
  else addZone(corners);
  drawn.value = [];
  tool.value = "select";
}
