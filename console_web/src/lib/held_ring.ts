// A ring round the dock: which headings hold station.
import { extent, HELD_ZONES, type Held, RAD, teeth } from "./held";
import { colour } from "./theme";

export interface Ring {
  x: number;
  y: number;
  radius: number;
  /** Of the picture against north, rad. */
  turn: number;
}

/** The ring: a heading is drawn where the hull lies with it, its bow to the dock. */
export function paintHeld(c: CanvasRenderingContext2D, held: Held, { x, y, radius, turn }: Ring): void {
  const at = (heading: number): number => (heading + 180 - 90) * RAD - turn;
  c.lineCap = "butt";
  for (const { zone, ink } of HELD_ZONES) {
    c.strokeStyle = colour(ink);
    c.lineWidth = zone === "refused" ? 1.5 : 5;
    c.setLineDash(zone === "warned" ? [5, 3] : []);
    for (const arc of held.arcs) {
      if (arc.zone !== zone) continue;
      const { from, width } = extent(arc);
      c.beginPath();
      c.arc(x, y, radius, at(from), at(from + width));
      if (zone === "refused")
        for (const tooth of teeth(from, width)) {
          const [cos, sin] = [Math.cos(at(tooth)), Math.sin(at(tooth))];
          c.moveTo(x + radius * cos, y + radius * sin);
          c.lineTo(x + (radius + 4) * cos, y + (radius + 4) * sin);
        }
      c.stroke();
    }
    c.setLineDash([]);
  }
  const [cos, sin] = [Math.cos(at(held.heading_deg)), Math.sin(at(held.heading_deg))];
  pointer(c, [x + (radius - 5) * cos, y + (radius - 5) * sin], at(held.heading_deg) + Math.PI);
}

/** The heading that is taken: a small head that points at the dock. */
function pointer(c: CanvasRenderingContext2D, [x, y]: readonly [number, number], towards: number): void {
  c.save();
  c.translate(x, y);
  c.rotate(towards);
  c.beginPath();
  c.moveTo(7, 0);
  c.lineTo(-2, 4.5);
  c.lineTo(-2, -4.5);
  c.closePath();
  c.fillStyle = colour("--ink");
  c.fill();
  c.restore();
}
