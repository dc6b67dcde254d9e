// The last minutes of modes as a strip: coloured and lettered, hatched while kappa is below 1,
// with the detection, raw above filtered, as two thin lines below.
import { Mode } from "../gen/bumpless_pb";
import { modeLook } from "../lib/modes";
import { colour } from "../lib/theme";
import { history } from "../stream/log";
import { Canvas } from "./canvas";
import { firstIndex, shown, spans, timeLabel } from "./time_axis";

const AXIS = 13;
const LAMPS = 11;

export function ModeStrip() {
  return <Canvas paint={paint} class="mode-strip" name="Modes over time, with transition ramp and detection" />;
}

function paint(g: CanvasRenderingContext2D, width: number, height: number): void {
  const [from, to] = shown();
  const x = (time: number): number => ((time - from) / (to - from)) * width;
  const lane = height - AXIS - LAMPS - 2;
  g.fillStyle = colour("--well");
  g.fillRect(0, 0, width, lane);
  g.fillRect(0, lane + 2, width, LAMPS - 2);
  if (!Number.isFinite(to)) return;

  for (const { mode, start, end } of spans(from, to)) {
    if (mode === Mode.UNSPECIFIED) continue;
    const look = modeLook(mode);
    const [left, right] = [Math.max(0, x(start)), x(end)];
    g.fillStyle = look.colour;
    g.fillRect(left, 0, Math.max(1, right - left), lane);
    if (right - left > 14) {
      g.fillStyle = "#06101c";
      g.font = "700 12px system-ui, sans-serif";
      g.textBaseline = "middle";
      g.textAlign = "left";
      g.fillText(right - left > 90 ? `${look.letter}  ${look.name}` : look.letter, left + 5, lane / 2 + 0.5);
    }
  }
  paintRamp(g, x, from, lane);
  paintDetection(g, x, from, "detection_raw", lane + 2);
  paintDetection(g, x, from, "detection", lane + 2 + LAMPS / 2 - 0.5);
  paintAxis(g, x, from, to, height);
}

/** While kappa < 1 the lane shows it as a dark wedge that shrinks to nothing. */
function paintRamp(g: CanvasRenderingContext2D, x: (t: number) => number, from: number, lane: number): void {
  const kappa = history.columns.kappa;
  if (!kappa) return;
  g.fillStyle = "rgb(6 16 28 / 0.55)";
  for (let i = Math.max(1, firstIndex(from)); i < history.time.length; i++) {
    const value = kappa[i];
    if (value == null || value >= 1) continue;
    const left = x(history.time[i - 1] as number);
    g.fillRect(left, 0, Math.max(0.6, x(history.time[i] as number) - left), lane * (1 - value));
  }
}

function paintDetection(
  g: CanvasRenderingContext2D, x: (t: number) => number, from: number, name: string, top: number,
): void {
  const column = history.columns[name];
  if (!column) return;
  g.fillStyle = colour(name === "detection" ? "--ink" : "--ink-2");
  for (let i = Math.max(1, firstIndex(from)); i < history.time.length; i++) {
    if (!column[i]) continue;
    const left = x(history.time[i - 1] as number);
    g.fillRect(left, top, Math.max(0.6, x(history.time[i] as number) - left), 3);
  }
}

function paintAxis(
  g: CanvasRenderingContext2D, x: (t: number) => number, from: number, to: number, height: number,
): void {
  g.fillStyle = colour("--ink-2");
  g.font = "10px system-ui, sans-serif";
  g.textBaseline = "bottom";
  const step = [5, 10, 30, 60].find((s) => (to - from) / s <= 8) ?? 120;
  const origin = Number.isFinite(history.missionStart) ? history.missionStart : to;
  for (let k = Math.ceil((from - origin) / step); origin + k * step <= to; k++) {
    const time = origin + k * step;
    const left = x(time);
    g.textAlign = left < 14 ? "left" : left > x(to) - 14 ? "right" : "center";
    g.fillText(timeLabel(time, to), left, height);
  }
}
