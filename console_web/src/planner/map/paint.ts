// The plan from above, drawn on a canvas: quick at any number of legs, without a graphics card.
import { colour } from "../../lib/theme";
import { paintCharts } from "../charts/paint";
import { paintTiles } from "../charts/paint_tiles";
import { paintDial, paintWaves } from "./paint/dial";
import { paintDock } from "./paint/dock";
import { paintFan, paintTrack } from "./paint/forecast";
import { paintGrid, paintScale } from "./paint/grid";
import { paintBox, paintMeasure } from "./paint/hand";
import { paintRings } from "./paint/held";
import { paintDrawn, paintOutlines } from "./paint/outlines";
import type { Ctx, Scene } from "./paint/scene";
import { paintLine } from "./paint/strokes";
import { paintStart, paintVehicle, paintWay, paintWaypoints } from "./paint/way";
import { paintDockZones } from "./paint/zones";

export function paintPlan(c: Ctx, s: Scene): void {
  paintTiles(c, s);
  paintCharts(c, s);
  paintGrid(c, s);
  paintOutlines(c, s);
  if (s.view.dock) paintRings(c, s, s.view.dock);
  if (s.view.dock) paintDockZones(c, s, s.view.dock);
  paintFan(c, s);
  paintWay(c, s);
  paintTrack(c, s);
  if (s.variant) {
    c.setLineDash([9, 4]);
    paintLine(c, s, s.variant.track.north_m, s.variant.track.east_m, colour("--reference"), 2);
    c.setLineDash([]);
  }
  if (s.picked) paintLine(c, s, s.picked.north_m, s.picked.east_m, colour("--alarm"), 2);
  if (s.view.dock) paintDock(c, s, s.view.dock);
  paintStart(c, s);
  paintWaypoints(c, s);
  if (s.vehicle) paintVehicle(c, s, s.vehicle);
  paintMeasure(c, s);
  paintDrawn(c, s);
  paintBox(c, s);
  paintDial(c, s);
  if (s.view.wave || s.waving) paintWaves(c, s);
  paintScale(c, s);
}
