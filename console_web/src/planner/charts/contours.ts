// A depth grid's places and its contour lines.
import { niceStep } from "../model/geometry";
import type { Point } from "../model/mission";
import type { ChartDepths, ChartShown } from "./charts";

const CONTOURS = 10;

/** Place of a grid's point by row and column, as shares from 0 to 1. */
export function cornerPlace(corners: NonNullable<ChartShown["corners"]>, u: number, v: number): Point {
  const [a, b, c, d] = corners as readonly [Point, Point, Point, Point];
  const mix = (axis: 0 | 1): number =>
    (1 - v) * ((1 - u) * a[axis] + u * b[axis]) + v * ((1 - u) * d[axis] + u * c[axis]);
  return [mix(0), mix(1)];
}

export interface Contour {
  depth: number;
  /** Pieces of the line: pairs of shares of the grid's width and height. */
  lines: readonly (readonly [number, number, number, number])[];
}

const contours = new WeakMap<ChartDepths, readonly Contour[]>();

/** Lines of equal depth, by marching squares; made once. */
export function contoursOf(depths: ChartDepths): readonly Contour[] {
  const before = contours.get(depths);
  if (before) return before;
  const step = niceStep((depths.deepest_m - depths.least_m) / CONTOURS);
  const found: Contour[] = [];
  for (let k = Math.ceil(depths.least_m / step); k * step <= depths.deepest_m; k++)
    found.push({ depth: Number((k * step).toFixed(6)), lines: contour(depths, k * step) });
  contours.set(depths, found);
  return found;
}

function contour({ rows, columns, depth_m }: ChartDepths, level: number): Contour["lines"] {
  const lines: [number, number, number, number][] = [];
  const at = (r: number, c: number): number | null => depth_m[r * columns + c] ?? null;
  for (let r = 0; r + 1 < rows; r++)
    for (let c = 0; c + 1 < columns; c++) {
      const cell = [at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)];
      if (cell.some((depth) => depth === null)) continue;
      const hits = crossings(cell as number[], level, r, c, rows, columns);
      for (let i = 0; i + 1 < hits.length; i += 2)
        lines.push([...(hits[i] as Point), ...(hits[i + 1] as Point)] as [number, number, number, number]);
    }
  return lines;
}

const CORNERS = [
  [0, 0],
  [0, 1],
  [1, 1],
  [1, 0],
] as const;

/** Where a level crosses the sides of a cell, as shares of the grid. */
function crossings(
  cell: readonly number[],
  level: number,
  row: number,
  column: number,
  rows: number,
  columns: number,
): Point[] {
  const found: Point[] = [];
  for (let k = 0; k < 4; k++) {
    const [a, b] = [cell[k] ?? 0, cell[(k + 1) % 4] ?? 0];
    if (a < level === b < level) continue;
    const share = (level - a) / (b - a);
    const [[ar, ac], [br, bc]] = [CORNERS[k] ?? [0, 0], CORNERS[(k + 1) % 4] ?? [0, 0]];
    found.push([
      (column + ac + share * (bc - ac)) / Math.max(1, columns - 1),
      (row + ar + share * (br - ar)) / Math.max(1, rows - 1),
    ]);
  }
  return found;
}
