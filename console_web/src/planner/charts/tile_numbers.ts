// Which tiles of a web map lie over a place, and where their corners are. Source: OpenStreetMap wiki, Slippy map tilenames.
export interface Tile {
  z: number;
  x: number;
  y: number;
}

const EQUATOR_M = 40_075_016.686;
const TILE_PX = 256;
const DEEPEST = 19;
const MOST = 64; // at once
const RAD = Math.PI / 180;

function numbers(latitude: number, longitude: number, z: number): readonly [number, number] {
  const n = 2 ** z;
  const x = ((longitude + 180) / 360) * n;
  const y = ((1 - Math.asinh(Math.tan(latitude * RAD)) / Math.PI) / 2) * n;
  return [x, y];
}

/** Latitude and longitude of a tile's corner, its upper left for (0, 0). */
export function tileCorner({ z, x, y }: Tile, right: 0 | 1, down: 0 | 1): readonly [number, number] {
  const n = 2 ** z;
  const latitude = Math.atan(Math.sinh(Math.PI * (1 - (2 * (y + down)) / n))) / RAD;
  return [latitude, ((x + right) / n) * 360 - 180];
}

/** The tiles over the box of some places, as fine as the scale shows, px for a metre. */
export function tilesOver(
  places: readonly (readonly [number, number])[],
  scale: number,
  latitude: number,
): Tile[] {
  const wide = EQUATOR_M * Math.cos(latitude * RAD) * scale;
  let z = Math.min(DEEPEST, Math.max(0, Math.round(Math.log2(wide / TILE_PX))));
  for (; z >= 0; z--) {
    const all = places.map(([lat, lon]) => numbers(lat, lon, z));
    const [xs, ys] = [all.map(([x]) => Math.floor(x)), all.map(([, y]) => Math.floor(y))];
    const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > MOST) continue;
    const found: Tile[] = [];
    for (let y = Math.max(0, y0); y <= Math.min(2 ** z - 1, y1); y++)
      for (let x = Math.max(0, x0); x <= Math.min(2 ** z - 1, x1); x++) found.push({ z, x, y });
    return found;
  }
  return [];
}
