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
    g.beginPath();
    for (let i = from; i <= to; i++)
      g.lineTo(
        plot.valToPos(times[i] as number, "x", true),
        plot.valToPos((about(i) as number) + limit, "y", true),
      );
    for (let i = to; i >= from; i--)
      g.lineTo(
        plot.valToPos(times[i] as number, "x", true),
        plot.valToPos((about(i) as number) - limit, "y", true),
      );
    g.fill();
  }
  g.restore();
}
