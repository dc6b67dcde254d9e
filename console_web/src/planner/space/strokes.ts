// Lines, faces and points in space, on a flat canvas.
import { colour } from "../../lib/theme";
import type { Ned } from "../model/geometry";
import type { Lens, Seen } from "./orbit";

export type Ctx = CanvasRenderingContext2D;

/** A way through places, as one path; parts behind the camera are left out. */
export function traceWay(c: Ctx, lens: Lens, places: readonly Ned[]): void {
  c.beginPath();
  let last: Seen | undefined;
  for (let i = 1; i < places.length; i++) {
    const part = lens.seeLine(places[i - 1] as Ned, places[i] as Ned);
    if (!part) continue;
    const [a, b] = part;
    if (!last || last[0] !== a[0] || last[1] !== a[1]) c.moveTo(a[0], a[1]);
    c.lineTo(b[0], b[1]);
    last = b;
  }
}

export function way(c: Ctx, lens: Lens, places: readonly Ned[], ink: string, width: number): void {
  traceWay(c, lens, places);
  c.strokeStyle = colour(ink);
  c.lineWidth = width;
  c.stroke();
}

export interface Face {
  places: readonly Ned[];
  ink: string;
  alpha: number;
  edge: string;
}

/** Faces from the farthest to the nearest, so that what is behind shines through. */
export function faces(c: Ctx, lens: Lens, all: readonly Face[]): void {
  const seen = all.flatMap((face) => {
    const points = face.places.map((place) => lens.see(place));
    if (points.some((point) => !point)) return [];
    const far = points.reduce((sum, point) => sum + (point?.[2] ?? 0), 0) / points.length;
    return [{ face, points: points as Seen[], far }];
  });
  seen.sort((a, b) => b.far - a.far);
  for (const { face, points } of seen) {
    c.beginPath();
    points.forEach(([x, y], i) => {
      if (i) c.lineTo(x, y);
      else c.moveTo(x, y);
    });
    c.closePath();
    c.fillStyle = colour(face.ink);
    c.globalAlpha = face.alpha;
    c.fill();
    c.globalAlpha = 1;
    if (!face.edge) continue;
    c.strokeStyle = colour(face.edge);
    c.lineWidth = 1;
    c.stroke();
  }
}
