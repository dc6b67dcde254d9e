// Events as marks at the plots' lower edge, a line for what counts: the same moments in all of them.
import type uPlot from "uplot";
import { Severity } from "../gen/bumpless_pb";
import { colour } from "../lib/theme";
import { screen } from "../stream/screen";

const LOOKS: Partial<Record<Severity, string>> = {
  [Severity.ALARM]: "--alarm",
  [Severity.WARNING]: "--warning",
};

export function marks(plot: uPlot): void {
  const { min, max } = plot.scales.x ?? {};
  if (min == null || max == null) return;
  const { left, top, width, height } = plot.bbox;
  const [g, size] = [plot.ctx, 4 * devicePixelRatio];
  g.save();
  for (const { stamp, severity, code } of screen.events) {
    const time = Number(stamp?.timeNs ?? 0n) / 1e9;
    if (time < min || time > max) continue;
    const look = LOOKS[severity];
    if (!look && code !== "mode_switch") continue;
    const x = left + ((time - min) / (max - min)) * width;
    g.strokeStyle = g.fillStyle = colour(look ?? "--ink-2");
    g.globalAlpha = look ? 0.8 : 0.45;
    g.beginPath();
    g.moveTo(x, top);
    g.lineTo(x, top + height);
    g.stroke();
    g.globalAlpha = 1;
    g.beginPath();
    g.moveTo(x, top + height - 1.6 * size);
    g.lineTo(x + size, top + height);
    g.lineTo(x - size, top + height);
    g.fill();
  }
  g.restore();
}
