// Round the dock: where the camera sees it, where to keep out, the cone and the circles that switch modes.
import { colour } from "../../../lib/theme";
import { along, type Ned, observationPoint } from "../../model/geometry";
import { approachOf, type MissionView } from "../../model/mission";
import type { Figures } from "../figures";
import type { Px } from "../viewport";
import { angle, type Ctx, px, type Scene, TAU } from "./scene";
import { note } from "./strokes";
import { text } from "./words";

export function paintDockZones(c: Ctx, s: Scene, wanted: NonNullable<MissionView["dock"]>): void {
  const dock = { ...wanted, heading: approachOf(wanted, s.view.current) };
  const f = s.figures;
  const [x, y] = px(s, dock.at);
  const k = s.viewport.sx;
  const end = observationPoint(dock.at, dock.heading, dock.standoff);
  if (f) {
    // From where the camera sees the marker with the bow on the approach heading.
    const half = (f.halfAngle * Math.PI) / 180;
    const back = angle(s, dock.heading + 180);
    c.fillStyle = colour("--accent");
    c.globalAlpha = 0.07;
    c.beginPath();
    c.moveTo(x, y);
    c.arc(x, y, f.sight * k, back - half, back + half);
    c.closePath();
    c.fill();
    c.globalAlpha = 0.5;
    c.strokeStyle = colour("--accent");
    c.setLineDash([2, 4]);
    c.lineWidth = 1;
    c.stroke();
    c.setLineDash([]);
    c.globalAlpha = 1;
    if (f.sight * k > 80)
      note(
        c,
        s,
        along(dock.at, dock.heading + 180 - f.halfAngle, f.sight),
        "camera sees the dock",
        "--accent",
      );
    if (f.docks) {
      const label = `keep out ${f.keepOut} m`;
      const towards = dock.heading + 105;
      ring(c, s, { at: dock.at, metres: f.keepOut, ink: "--alarm", dash: [6, 5], label, towards });
      paintCone(c, s, dock, end, f);
    }
    const rings = [
      { metres: f.thresholds.rh, ink: "--mode-hover", word: "hover" },
      { metres: f.thresholds.fr, ink: "--mode-reverse", word: "reverse" },
    ];
    for (const { metres, ink, word } of rings) {
      const label = `${word} ${metres} m`;
      ring(c, s, { at: end, metres, ink, dash: [3, 4], label, towards: dock.heading - 60 });
    }
  }
  if (dock.tolerance > 0 && dock.tolerance < 180 && !dock.intoCurrent) {
    const t = (dock.tolerance * Math.PI) / 180;
    const back = angle(s, wanted.heading + 180);
    c.fillStyle = colour("--reference");
    c.globalAlpha = 0.12;
    c.beginPath();
    c.moveTo(x, y);
    c.arc(x, y, Math.max(60, 6 * k), back - t, back + t);
    c.fill();
    c.globalAlpha = 1;
  }
}

interface Ring {
  at: Ned;
  metres: number;
  ink: string;
  dash: number[];
  label: string;
  /** Heading from the middle at which the label stands. */
  towards: number;
}

function ring(c: Ctx, s: Scene, { at, metres, ink, dash, label, towards }: Ring): void {
  const [x, y] = px(s, at);
  const radius = metres * s.viewport.sx;
  if (radius < 3) return;
  c.strokeStyle = colour(ink);
  c.lineWidth = 1;
  c.setLineDash(dash);
  c.beginPath();
  c.arc(x, y, radius, 0, TAU);
  c.stroke();
  c.setLineDash([]);
  if (radius < 34) return;
  const way = angle(s, towards);
  const [lx, ly] = [x + (radius + 5) * Math.cos(way), y + (radius + 5) * Math.sin(way)];
  text(c, label, lx, ly + 3, "--ink-2", 400, {
    size: "--text-2xs",
    align: Math.cos(way) < 0 ? "right" : "left",
  });
}

function paintCone(c: Ctx, s: Scene, dock: { heading: number }, end: Ned, f: Figures): void {
  const side = (left: number, sign: number): Px =>
    px(
      s,
      along(along(end, dock.heading, -left), dock.heading + 90 * sign, f.cone.base + f.cone.slope * left),
    );
  const far = f.entry;
  const corners = [side(0, 1), side(far, 1), side(far, -1), side(0, -1)];
  c.beginPath();
  corners.forEach(([x, y], i) => {
    if (i) c.lineTo(x, y);
    else c.moveTo(x, y);
  });
  c.closePath();
  c.fillStyle = colour("--mode-hover");
  c.globalAlpha = 0.09;
  c.fill();
  c.globalAlpha = 0.55;
  c.strokeStyle = colour("--mode-hover");
  c.lineWidth = 1;
  c.stroke();
  c.globalAlpha = 1;
}
