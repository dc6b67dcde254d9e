// A depth grid as a picture.
import { colour } from "../../lib/theme";
import type { ChartDepths } from "./charts";

function rgb(name: string): [number, number, number] {
  const hex = colour(name).replace("#", "");
  return [0, 2, 4].map((at) => Number.parseInt(hex.slice(at, at + 2), 16)) as [number, number, number];
}

const pictures = new WeakMap<ChartDepths, { theme: string; canvas: HTMLCanvasElement }>();

/** The grid as a picture, a pixel for each point: shallow is strong, deep fades, land is sand. */
export function gridPicture(depths: ChartDepths, theme: string): HTMLCanvasElement {
  const before = pictures.get(depths);
  if (before?.theme === theme) return before.canvas;
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [depths.columns, depths.rows];
  const c = canvas.getContext("2d");
  const image = c?.createImageData(depths.columns, depths.rows);
  if (c && image) {
    const [water, land] = [rgb("--trace"), rgb("--warning")];
    const most = Math.max(1e-6, depths.deepest_m);
    depths.depth_m.forEach((depth, i) => {
      if (depth === null) return;
      const ink = depth > 0 ? water : land;
      image.data.set([...ink, depth > 0 ? 150 * (1 - depth / most) ** 1.5 + 14 : 120], 4 * i);
    });
    c.putImageData(image, 0, 0);
  }
  pictures.set(depths, { theme, canvas });
  return canvas;
}
