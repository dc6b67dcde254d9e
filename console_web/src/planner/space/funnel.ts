// Round the dock in space: the cone in which the camera sees it, and the strip that an approach must keep to.
import type { Figures } from "../map/figures";
import { along, type Ned, observationPoint } from "../model/geometry";
import { approachOf } from "../model/mission";
import type { SpaceScene } from "./scene";
import { approachStrip } from "./strip";
import { type Ctx, faces, way } from "./strokes";

const RING_POINTS = 32;
const EDGES = 8;

/** Where the camera sees the marker: before the dock, as wide up and down as it is aside. */
function sightRing(at: Ned, heading: number, range: number, halfDeg: number): Ned[] {
  const half = (halfDeg * Math.PI) / 180;
  const [n, e, d] = along(at, heading + 180, range * Math.cos(half));
  const radius = range * Math.sin(half);
  return Array.from({ length: RING_POINTS + 1 }, (_, i): Ned => {
    const turn = (2 * Math.PI * i) / RING_POINTS;
    const [pn, pe] = along([n, e, d], heading + 90, radius * Math.cos(turn));
    return [pn, pe, d + radius * Math.sin(turn)];
  });
}

export function paintFunnel(
  c: Ctx,
  s: SpaceScene,
  dock: NonNullable<SpaceScene["view"]["dock"]>,
  figures: Figures,
): void {
  const heading = approachOf(dock, s.view.current);
  const ring = sightRing(dock.at, heading, figures.sight, figures.halfAngle);
  c.globalAlpha = 0.5;
  way(c, s.lens, ring, "--trace", 1);
  for (let i = 0; i < RING_POINTS; i += RING_POINTS / EDGES)
    way(c, s.lens, [dock.at, ring[i] as Ned], "--trace", 0.6);
  c.globalAlpha = 1;
  if (!figures.docks) return;
  const end = observationPoint(dock.at, heading, dock.standoff);
  faces(c, s.lens, [
    { places: approachStrip(end, heading, figures), ink: "--mode-hover", alpha: 0.16, edge: "--mode-hover" },
  ]);
}
