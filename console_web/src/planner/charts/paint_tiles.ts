// The base map beneath all else, each tile on its corners.
import { colour, font } from "../../lib/theme";
import { type Ctx, px, type Scene } from "../map/paint/scene";
import { toLocal } from "../model/earth";
import { tileCorner } from "./tile_numbers";
import { tilesUnder } from "./tiles";

const OVERLAP_PX = 0.5; // no seams

export function paintTiles(c: Ctx, s: Scene): void {
  if (!s.tiles) return;
  const { address, attribution, origin } = s.tiles;
  c.globalAlpha = 0.6;
  for (const { tile, image } of tilesUnder(address, origin, s.viewport, s.size)) {
    const corner = (right: 0 | 1, down: 0 | 1) => px(s, toLocal(origin, ...tileCorner(tile, right, down)));
    const [a, b, d] = [corner(0, 0), corner(1, 0), corner(0, 1)];
    const [w, h] = [image.naturalWidth, image.naturalHeight];
    c.save();
    c.transform((b[0] - a[0]) / w, (b[1] - a[1]) / w, (d[0] - a[0]) / h, (d[1] - a[1]) / h, a[0], a[1]);
    c.drawImage(image, 0, 0, w + OVERLAP_PX, h + OVERLAP_PX);
    c.restore();
  }
  c.globalAlpha = 1;
  if (!attribution) return;
  c.font = font("--text-2xs");
  c.fillStyle = colour("--ink-2");
  c.textAlign = "right";
  c.fillText(attribution, s.size.width - 8, s.size.height - 40);
}
