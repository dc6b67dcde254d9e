// The last minutes of modes as a strip: coloured and lettered, hatched while kappa is below 1,
// with the detection, raw above filtered, as two thin lines below.
import { useMemo } from "preact/hooks";
import { Mode } from "../gen/bumpless_pb";
import { modeLook } from "../lib/modes";
import { colour, font, typeSize } from "../lib/theme";
import { screen } from "../stream/screen";
import { Canvas } from "../ui/canvas";
import { pace } from "./pace";
import { shown, spans, ticks, timeLabel } from "./time_axis";

/** Heights, in type sizes of the page. */
const AXIS = 1;
const LAMPS = 0.85;

export function ModeStrip() {
  const due = useMemo(pace, []);
  return (
    <Canvas
      paint={paint}
      due={due}
      class="mode-strip"
      name="Modes over time, with transition ramp and detection"
    />
  );
}

function paint(g: CanvasRenderingContext2D, width: number, height: number): void {
  const [from, to] = shown();
  const x = (time: number): number => ((time - from) / (to - from)) * width;
  const lamps = LAMPS * typeSize.peek();
  const lane = height - AXIS * typeSize.peek() - lamps - 2;
  g.fillStyle = colour("--well");
  g.fillRect(0, 0, width, lane);
  g.fillRect(0, lane + 2, width, lamps - 2);
  if (!Number.isFinite(to)) return;

  for (const { mode, start, end } of spans(from, to)) {
    if (mode === Mode.UNSPECIFIED) continue;
    const look = modeLook(mode);
    const [left, right] = [Math.max(0, x(start)), x(end)];
    g.fillStyle = look.colour;
    g.fillRect(left, 0, Math.max(1, right - left), lane);
    if (right - left > 14) {
      g.fillStyle = colour("--on-mode");
      g.font = font("--text-sm", 700);
      g.textBaseline = "middle";
      g.textAlign = "left";
      g.fillText(right - left > 90 ? `${look.letter}  ${look.name}` : look.letter, left + 5, lane / 2 + 0.5);
    }
  }
  paintRamp(g, x, from, to, lane);
  paintDetection(g, x, from, to, "detection_raw", lane + 2);
  paintDetection(g, x, from, to, "detection", lane + 2 + lamps / 2 - 0.5);
  paintAxis(g, x, from, to, height);
}

/** While kappa < 1 the lane shows it as a dark wedge that shrinks to nothing. */
function paintRamp(
  g: CanvasRenderingContext2D,
  x: (t: number) => number,
  from: number,
  to: number,
  lane: number,
): void {
  const kappa = screen.history.column("kappa");
  if (!kappa) return;
  g.fillStyle = colour("--shade");
  const end = screen.history.firstIndex(to + 1e-6);
  for (let i = Math.max(1, screen.history.firstIndex(from)); i < end; i++) {
    const value = kappa[i] as number;
    if (!(value < 1)) continue;
    const right = x(screen.history.time[i] as number);
    const left = x((screen.history.time[i] as number) - screen.history.stretch(i));
    g.fillRect(left, 0, Math.max(0.6, right - left), lane * (1 - value));
  }
}

function paintDetection(
  g: CanvasRenderingContext2D,
  x: (t: number) => number,
  from: number,
  to: number,
  name: string,
  top: number,
): void {
  const column = screen.history.column(name);
  if (!column) return;
  g.fillStyle = colour(name === "detection" ? "--ink" : "--ink-2");
  const end = screen.history.firstIndex(to + 1e-6);
  for (let i = Math.max(1, screen.history.firstIndex(from)); i < end; i++) {
    if (!column[i]) continue;
    const right = x(screen.history.time[i] as number);
    const left = x((screen.history.time[i] as number) - screen.history.stretch(i));
    g.fillRect(left, top, Math.max(0.6, right - left), 3);
  }
}

function paintAxis(
  g: CanvasRenderingContext2D,
  x: (t: number) => number,
  from: number,
  to: number,
  height: number,
): void {
  g.fillStyle = colour("--ink-2");
  g.font = font("--text-2xs");
  g.textBaseline = "bottom";
  const most = Math.min(8, x(to) / (4.2 * typeSize.peek())); // the first label moves inwards, towards the next
  const step = [5, 10, 20, 30, 60].find((s) => (to - from) / s <= most) ?? 120;
  for (const time of ticks(from, to, step)) {
    const left = x(time);
    g.textAlign = left < 14 ? "left" : left > x(to) - 14 ? "right" : "center";
    g.fillText(timeLabel(time, to), left, height);
  }
}
