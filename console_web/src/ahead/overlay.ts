// The flights ahead in the live plots: dashed, past the present. "As it is" faint, the draft strong.
import type uPlot from "uplot";
import { colour } from "../lib/theme";
import { screen } from "../stream/screen";
import { linesOf, reach } from "./flights";

const DASH = [7, 4];

/** Seconds past the present that the plots show for the flights ahead; 0 without any, and in a replay. */
export function room(): number {
  if (!screen.isLive || screen.until < screen.history.last()) return 0; // or the plots are held in the past
  const left = reach() - screen.history.last();
  return Number.isFinite(left) ? Math.max(left, 0) : 0;
}

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
