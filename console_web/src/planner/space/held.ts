// The rings of headings that hold station, in space: level, at the dock's depth.
import { extent, HELD_ZONES, type Held, teeth } from "../../lib/held";
import { along, type Ned } from "../model/geometry";
import type { SpaceScene } from "./scene";
import { type Ctx, way } from "./strokes";

const RING_PX = 66;
const OUTER_PX = 82;
const LEAST_M = 2;
const STEP_DEG = 4;

export function paintRings(c: Ctx, s: SpaceScene, dock: Ned): void {
  const metres = (px: number): number => Math.max(LEAST_M, (px * s.lens.orbit.distance) / s.lens.scale);
  c.globalAlpha = s.stale ? 0.35 : 1;
  if (s.held) ring(c, s, dock, s.held, metres(RING_PX));
  c.globalAlpha = 1;
  if (s.heldNow) ring(c, s, dock, s.heldNow, metres(OUTER_PX));
}

function ring(c: Ctx, s: SpaceScene, dock: Ned, held: Held, metres: number): void {
  // Where the hull lies with a heading: astern of the dock.
  const at = (heading: number, far = 1): Ned => along(dock, heading + 180, metres * far);
  for (const { zone, ink } of HELD_ZONES) {
    c.setLineDash(zone === "warned" ? [5, 3] : []);
    for (const arc of held.arcs) {
      if (arc.zone !== zone) continue;
      const { from, width } = extent(arc);
      const steps = Math.max(1, Math.ceil(width / STEP_DEG));
      const places = Array.from({ length: steps + 1 }, (_, i) => at(from + (i * width) / steps));
      way(c, s.lens, places, ink, zone === "refused" ? 1.2 : 3.5);
      if (zone !== "refused") continue;
      for (const tooth of teeth(from, width)) way(c, s.lens, [at(tooth), at(tooth, 1.06)], ink, 1.2);
    }
    c.setLineDash([]);
  }
  way(c, s.lens, [at(held.heading_deg, 0.86), at(held.heading_deg)], "--ink", 3);
}
