// Charts beneath the plan from above.
import { colour, font } from "../../lib/theme";
import { type Ctx, px, type Scene, TAU } from "../map/paint/scene";
import type { Point } from "../model/mission";
import type { ChartFeature, ChartShown, Drawn } from "./charts";
import { contoursOf, cornerPlace } from "./contours";
import { gridPicture } from "./grid";

export function paintCharts(c: Ctx, s: Scene): void {
  for (const chart of s.charts) {
    if (chart.shown.depths) paintDepths(c, s, chart.shown);
    else if (chart.picture) paintPicture(c, s, chart);
    else for (const feature of chart.shown.features) paintFeature(c, s, feature);
  }
}

/** Lay a picture's pixels on its corners; `half`: the corners are the middles of the outer pixels. */
function lay(
  c: Ctx,
  s: Scene,
  corners: NonNullable<ChartShown["corners"]>,
  picture: HTMLImageElement | HTMLCanvasElement,
  half: boolean,
): void {
  const [w, h] = half
    ? [Math.max(1, picture.width - 1), Math.max(1, picture.height - 1)]
    : [picture.width, picture.height];
  const [a, b, , d] = corners.map((corner) => px(s, corner as Point));
  if (!a || !b || !d) return;
  const [ux, uy, vx, vy] = [(b[0] - a[0]) / w, (b[1] - a[1]) / w, (d[0] - a[0]) / h, (d[1] - a[1]) / h];
  const off = half ? 0.5 : 0;
  c.save();
  c.transform(ux, uy, vx, vy, a[0] - off * (ux + vx), a[1] - off * (uy + vy));
  c.drawImage(picture, 0, 0);
  c.restore();
}

function paintPicture(c: Ctx, s: Scene, { shown, picture }: Drawn): void {
  if (!shown.corners || !picture) return;
  c.globalAlpha = 0.75;
  lay(c, s, shown.corners, picture, false);
  c.globalAlpha = 1;
}

function paintDepths(c: Ctx, s: Scene, { depths, corners }: ChartShown): void {
  if (!depths || !corners) return;
  lay(c, s, corners, gridPicture(depths, s.theme), true);
  c.font = font("--text-2xs");
  c.textAlign = "center";
  for (const { depth, lines } of contoursOf(depths)) {
    c.beginPath();
    for (const [u0, v0, u1, v1] of lines) {
      c.moveTo(...px(s, cornerPlace(corners, u0, v0)));
      c.lineTo(...px(s, cornerPlace(corners, u1, v1)));
    }
    c.strokeStyle = colour(depth > 0 ? "--line-2" : "--warning");
    c.lineWidth = 1;
    c.stroke();
    const middle = lines[Math.floor(lines.length / 2)];
    if (!middle) continue;
    const [x, y] = px(s, cornerPlace(corners, middle[0], middle[1]));
    c.fillStyle = colour("--ink-2");
    c.fillText(String(depth), x, y + 4);
  }
}

function paintFeature(c: Ctx, s: Scene, { kind, name, colour: own, parts }: ChartFeature): void {
  const ink = own || colour("--reference");
  c.strokeStyle = ink;
  c.fillStyle = ink;
  c.lineWidth = 1.5;
  c.beginPath();
  for (const part of parts) {
    part.forEach((place, i) => {
      const [x, y] = px(s, place as unknown as Point);
      if (kind === "point") {
        c.moveTo(x + 4, y);
        c.arc(x, y, 4, 0, TAU);
      } else if (i) c.lineTo(x, y);
      else c.moveTo(x, y);
    });
    if (kind === "area") c.closePath();
  }
  if (kind !== "line") {
    c.globalAlpha = kind === "area" ? 0.12 : 1;
    c.fill("evenodd");
    c.globalAlpha = 1;
  }
  c.stroke();
  const first = parts[0]?.[0];
  if (!name || !first) return;
  const [x, y] = px(s, first as unknown as Point);
  c.font = font("--text-2xs");
  c.textAlign = "left";
  c.fillText(name, x + 7, y - 5);
}
