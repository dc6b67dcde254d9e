// The sea floor of a depth grid in space: a net of its rows and columns, the deeper the fainter.
import type { ChartShown } from "../charts/charts";
import { cornerPlace } from "../charts/contours";
import type { Ned } from "../model/geometry";
import type { SpaceScene } from "./scene";
import { type Ctx, type Face, faces } from "./strokes";

const MOST = 36; // rows and columns that are drawn

const nets = new WeakMap<ChartShown, Ned[][]>();

function netOf(shown: ChartShown): (Ned | undefined)[][] {
  const before = nets.get(shown);
  if (before) return before;
  const { depths, corners } = shown;
  if (!depths || !corners) return [];
  const { rows, columns, depth_m } = depths;
  const pick = (count: number): number[] => {
    const n = Math.min(MOST, count);
    return Array.from({ length: n }, (_, i) => Math.round((i * (count - 1)) / Math.max(1, n - 1)));
  };
  const net = pick(rows).map((r) =>
    pick(columns).map((k): Ned | undefined => {
      const depth = depth_m[r * columns + k];
      if (depth === null || depth === undefined) return undefined;
      return [...cornerPlace(corners, k / Math.max(1, columns - 1), r / Math.max(1, rows - 1)), depth];
    }),
  );
  nets.set(shown, net as Ned[][]);
  return net;
}

export function paintTerrain(c: Ctx, s: SpaceScene, shown: ChartShown): void {
  const net = netOf(shown);
  const deepest = Math.max(1, shown.depths?.deepest_m ?? 1);
  const all: Face[] = [];
  for (let r = 0; r + 1 < net.length; r++)
    for (let k = 0; k + 1 < (net[r]?.length ?? 0); k++) {
      const places = [net[r]?.[k], net[r]?.[k + 1], net[r + 1]?.[k + 1], net[r + 1]?.[k]];
      if (places.some((place) => !place)) continue;
      const depth = (places as Ned[]).reduce((sum, place) => sum + place[2], 0) / 4;
      const ink = depth > 0 ? "--trace" : "--warning";
      all.push({
        places: places as Ned[],
        ink,
        alpha: 0.32 - 0.26 * Math.min(1, depth / deepest),
        edge: "--grid",
      });
    }
  faces(c, s.lens, all);
}
