// The flights ahead in the live plots: dashed, past the present. "As it is" faint, the draft strong.
import type uPlot from "uplot";
import { colour } from "../lib/theme";
import { linesOf } from "./flights";
import { room } from "./room";

const DASH = [7, 4];

/** A hook of uPlot's: draw what the flights ahead say of a column. */
export function drawAhead(column: string): (plot: uPlot) => void {
  return (plot) => {
    if (!room()) return;
    const g = plot.ctx;
    const { left, top, width, height } = plot.bbox;
    g.save();
    g.beginPath();
    g.rect(left, top, width, height);
    g.clip();
    g.setLineDash(DASH.map((n) => n * devicePixelRatio));
    for (const { name, time, values } of linesOf(column)) {
      g.strokeStyle = colour(name === "draft" ? "--run-2" : "--ink-2");
      g.lineWidth = (name === "draft" ? 2 : 1.4) * devicePixelRatio;
      g.beginPath();
      for (const [i, value] of values.entries()) {
        if (value === null) continue;
        g.lineTo(plot.valToPos(time[i] as number, "x", true), plot.valToPos(value, "y", true));
      }
      g.stroke();
    }
    g.restore();
  };
}

/** Least and largest of what is drawn of a column, so that the scale holds it. */
export function extent(column: string): [low: number, high: number] | undefined {
  if (!room()) return undefined;
  const values = linesOf(column).flatMap((line) => line.values.filter((value) => value !== null));
  return values.length ? [Math.min(...values), Math.max(...values)] : undefined;
}
