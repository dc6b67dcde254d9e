// A base map beneath the plan: tiles of the address that the server's settings name, none by default.
import { signal } from "@preact/signals";
import { ask } from "../../api/client";
import { Resource } from "../../api/resource";
import type { Size, Viewport } from "../map/viewport";
import { toMetres } from "../map/viewport";
import { type Origin, toEarth } from "../model/earth";
import { type Tile, tilesOver } from "./tile_numbers";

export const source = new Resource(() => ask("get", "/api/charts/tiles"));
const MOST_KEPT = 400;

const kept = new Map<string, HTMLImageElement>();
/** Grows with each tile that has come, so that the picture is drawn anew. */
export const come = signal(0);

function address(pattern: string, { z, x, y }: Tile): string {
  return pattern.replace("{z}", String(z)).replace("{x}", String(x)).replace("{y}", String(y));
}

function tile(url: string): HTMLImageElement {
  const before = kept.get(url);
  if (before) return before;
  const [oldest] = kept.keys();
  if (kept.size >= MOST_KEPT && oldest !== undefined) kept.delete(oldest);
  const image = new Image();
  image.referrerPolicy = "no-referrer";
  image.onload = () => {
    come.value++;
  };
  image.src = url;
  kept.set(url, image);
  return image;
}

/** The tiles that lie under the canvas and have come. */
export function tilesUnder(
  pattern: string,
  origin: Origin,
  v: Viewport,
  size: Size,
): { tile: Tile; image: HTMLImageElement }[] {
  if (!pattern || !size.width) return [];
  const { width, height } = size;
  const places = [
    [0, 0],
    [width, 0],
    [width, height],
    [0, height],
  ].map(([x, y]) => {
    const [east, north] = toMetres(v, size, x ?? 0, y ?? 0);
    return toEarth(origin, north, east);
  });
  return tilesOver(places, v.sx, origin.latitude)
    .map((one) => ({ tile: one, image: tile(address(pattern, one)) }))
    .filter(({ image }) => image.complete && image.naturalWidth > 0);
}
