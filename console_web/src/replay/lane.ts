// The mode lane under the scrubber: the whole run's modes, its switches and alarms.
import { Mode, Severity } from "../gen/bumpless_pb";
import { modeLook } from "../lib/modes";
import { colour } from "../lib/theme";
import { spans } from "../live/time_axis";
import type { Replay } from "./replay";

const LANE = 0.62;

export function paintLane(replay: Replay, g: CanvasRenderingContext2D, width: number, height: number): void {
  const [first, last] = [replay.first, replay.last];
  const start = replay.history.missionStart;
  if (!(last > first)) return;
  const x = (t: number): number => ((t - first) / (last - first)) * width;
  g.fillStyle = colour("--well");
  g.fillRect(0, 0, width, height * LANE);
  if (Number.isFinite(start)) {
    for (const { mode, start: a, end } of spans(start + first, start + last, replay.history)) {
      if (mode === Mode.UNSPECIFIED) continue;
      g.fillStyle = modeLook(mode).colour;
      g.fillRect(x(a - start), 0, Math.max(1, x(end - start) - x(a - start)), height * LANE);
    }
  }
  for (const [from, to] of replay.gaps) hatch(g, x(from), x(to), height * LANE);
  for (const event of replay.every) {
    const at = x(event.stamp?.missionTimeS ?? 0);
    const alarm = event.severity >= Severity.ALARM;
    if (event.severity < Severity.WARNING && event.code !== "mode_switch") continue;
    g.fillStyle = colour(alarm ? "--alarm" : event.code === "mode_switch" ? "--ink" : "--warning");
    g.fillRect(at - 1, event.code === "mode_switch" ? 0 : height * LANE + 1, 2, height * (1 - LANE) - 1);
  }
}

/** What was not recorded: no mode, and not nothing either. */
function hatch(g: CanvasRenderingContext2D, from: number, to: number, height: number): void {
  g.save();
  g.beginPath();
  g.rect(from, 0, Math.max(2, to - from), height);
  g.clip();
  g.fillStyle = colour("--well");
  g.fillRect(from, 0, Math.max(2, to - from), height);
  g.strokeStyle = colour("--warning");
  g.lineWidth = 1.5;
  g.beginPath();
  for (let at = from - height; at < to + height; at += 6) {
    g.moveTo(at, height);
    g.lineTo(at + height, 0);
  }
  g.stroke();
  g.restore();
}
