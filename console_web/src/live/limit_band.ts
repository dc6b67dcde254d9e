// The band about a reference inside which no alarm watches: an error outside it counts once it lasts.
import type uPlot from "uplot";
import { colour } from "../lib/theme";
import { limits } from "./limits";
import type { PlotSpec } from "./plots";
import { stretches } from "./stretches";

export function band(plot: uPlot, spec: PlotSpec): void {
  const limit = spec.limit && limits.value?.[spec.limit];
  const times = plot.data[0];
  if (!limit || !times.length) return;
  const index = spec.traces.findIndex(({ look }) => look === "reference");
  const reference = index < 0 ? undefined : plot.data[index + 1];
  const about = (i: number): number | null | undefined => (index < 0 ? 0 : reference?.[i]);
  const g = plot.ctx;
  g.save();
  g.beginPath();
  g.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
  g.clip();
  g.fillStyle = colour("--reference");
  g.globalAlpha = 0.1;
  for (const [from, to] of stretches(times.length, about)) {
    const middle = apart(plot, times, from, to).map((i) => [times[i] as number, about(i) as number] as const);
    const at = ([time, value]: readonly [number, number], off: number): void =>
      g.lineTo(plot.valToPos(time, "x", true), plot.valToPos(value + off, "y", true));
    g.beginPath();
    for (const point of middle) at(point, limit);
    for (const point of middle.toReversed()) at(point, -limit);
    g.fill();
  }
  g.restore();
}

/** Rows at least a pixel apart, and the ends: thousands of corners in a few hundred pixels cost and show nothing. */
function apart(plot: uPlot, times: ArrayLike<number>, from: number, to: number): number[] {
  const { min = 0, max = 0 } = plot.scales.x ?? {};
  const pixel = ((max ?? 0) - (min ?? 0)) / Math.max(1, plot.bbox.width);
  const rows: number[] = [];
  let next = Number.NEGATIVE_INFINITY;
  for (let i = from; i <= to; i++) {
    if (i < to && (times[i] as number) < next) continue;
    rows.push(i);
    next = (times[i] as number) + pixel;
  }
  return rows;
}
