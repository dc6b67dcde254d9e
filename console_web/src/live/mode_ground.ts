// The modes as a faint ground under a plot's lines, with their letters above: colour never alone.
import type uPlot from "uplot";
import { Mode } from "../gen/bumpless_pb";
import { modeLook } from "../lib/modes";
import { colour, font } from "../lib/theme";
import { spans } from "./time_axis";

interface Box {
  mode: Mode;
  left: number;
  width: number;
}

function boxes(plot: uPlot): Box[] {
  const { min, max } = plot.scales.x ?? {};
  if (min == null || max == null) return [];
  const at = (time: number): number =>
    plot.bbox.left + ((Math.min(Math.max(time, min), max) - min) / (max - min)) * plot.bbox.width;
  return spans(min, max)
    .filter(({ mode }) => mode !== Mode.UNSPECIFIED)
    .map(({ mode, start, end }) => ({ mode, left: at(start), width: at(end) - at(start) }));
}

export function shade(plot: uPlot): void {
  const { top, height } = plot.bbox;
  const g = plot.ctx;
  g.save();
  for (const { mode, left, width } of boxes(plot)) {
    g.fillStyle = modeLook(mode).colour;
    g.globalAlpha = 0.13;
    g.fillRect(left, top, width, height);
    g.globalAlpha = 0.9;
    g.fillRect(left, top, width, 2 * devicePixelRatio);
  }
  g.restore();
}

export function letter(plot: uPlot): void {
  const g = plot.ctx;
  const scale = devicePixelRatio;
  g.save();
  g.font = font("--text-2xs", 700, scale);
  g.textBaseline = "top";
  g.textAlign = "left";
  g.fillStyle = colour("--ink");
  for (const { mode, left, width } of boxes(plot)) {
    if (width > 14 * scale) g.fillText(modeLook(mode).letter, left + 4 * scale, plot.bbox.top + 5 * scale);
  }
  g.restore();
}
