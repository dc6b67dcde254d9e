// One uPlot chart outside the component tree: Preact makes its box, frames feed it.
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import { Mode } from "../gen/bumpless_pb";
import { fixed, headingOf } from "../lib/format";
import { modeLook } from "../lib/modes";
import { colour, onTheme } from "../lib/theme";
import { history } from "../stream/log";
import { onFrame } from "../stream/frame";
import type { PlotSpec } from "./plots";
import { shown, spans, timeLabel, window_s } from "./time_axis";

export function Plot({ spec, axis }: { spec: PlotSpec; axis: boolean }) {
  const box = useRef<HTMLDivElement>(null);
  const values = useRef<HTMLSpanElement>(null);
  useEffect(() => (box.current ? mount(box.current, values.current, spec, axis) : undefined), [spec.id, axis]);
  return (
    <figure class="plot" aria-label={`${spec.title} over time, ${spec.unit}`}>
      <figcaption>
        <b>{spec.title}</b> <span class="unit">{spec.unit}</span>
        <span class="grow" />
        <span class="plot-values num" ref={values} data-testid={`plot-${spec.id}`}>
          <span class="value-measured" />
          {spec.traces.some(({ look }) => look === "reference") && <span class="value-reference" />}
        </span>
      </figcaption>
      <div class="plot-box" ref={box} />
    </figure>
  );
}

function mount(box: HTMLElement, values: HTMLElement | null, spec: PlotSpec, axis: boolean): () => void {
  let plot: uPlot | undefined;
  const make = (): void => {
    plot?.destroy();
    plot = new uPlot(options(spec, axis, box.clientWidth, box.clientHeight), dataOf(spec), box);
  };
  const feed = (): void => {
    if (!plot || !box.clientHeight) return;
    plot.setData(dataOf(spec));
    if (values) showValues(values, spec, plot);
  };
  make();
  const size = new ResizeObserver(() => {
    if (box.clientWidth && box.clientHeight) plot?.setSize({ width: box.clientWidth, height: box.clientHeight });
  });
  size.observe(box);
  const stopFrames = onFrame(feed);
  const stopTheme = onTheme(make);
  return () => {
    size.disconnect();
    stopFrames();
    stopTheme();
    plot?.destroy();
  };
}

function dataOf(spec: PlotSpec): uPlot.AlignedData {
  const none = history.time.map(() => null);
  return [history.time, ...spec.traces.map((trace) => history.columns[trace.column] ?? none)];
}

/** Values under the cursor, else the newest. */
function showValues(element: HTMLElement, spec: PlotSpec, plot: uPlot): void {
  const index = plot.cursor.idx ?? history.time.length - 1;
  for (const trace of spec.traces) {
    const value = history.columns[trace.column]?.[index];
    const text = (spec.heading ? headingOf : fixed)(value, spec.decimals);
    const part = element.querySelector(`.value-${trace.look}`);
    if (part && part.textContent !== text) part.textContent = text;
  }
}

function options(spec: PlotSpec, axis: boolean, width: number, height: number): uPlot.Options {
  const ink = colour("--ink-2");
  const grid = { stroke: colour("--grid"), width: 1 };
  const font = "10px system-ui, sans-serif";
  return {
    width: Math.max(60, width),
    height: Math.max(40, height),
    legend: { show: false },
    cursor: { sync: { key: "live" }, drag: { x: false, y: false }, points: { size: 5 }, y: false },
    padding: [5, 16, axis ? 0 : 5, 0],
    scales: {
      x: { time: false, range: () => timeScale() },
      y: { dir: spec.downward ? -1 : 1, range: (_, low, high) => span(low, high, spec.smallestSpan) },
    },
    axes: [
      {
        show: axis, stroke: ink, font, grid, ticks: { show: false }, size: 16, gap: 2, space: 56,
        splits: (plot) => timeSplits(plot), values: (_, ticks) => ticks.map((t) => timeLabel(t, history.last())),
      },
      {
        stroke: ink, font, grid, ticks: { show: false }, size: 38, gap: 3, space: 22,
        values: (_, ticks) => axisTexts(ticks, spec.heading ?? false),
      },
    ],
    series: [
      {},
      ...spec.traces.map((trace): uPlot.Series => ({
        stroke: colour(trace.look === "measured" ? "--trace" : "--reference"),
        width: trace.look === "measured" ? 1.6 : 1.3,
        ...(trace.look === "reference" ? { dash: [5, 4] } : {}),
        points: { show: false },
        spanGaps: false,
      })),
    ],
    hooks: { drawClear: [shade], draw: [letter] },
  };
}

function span(low: number | null, high: number | null, smallest: number): [number, number] {
  if (low === null || high === null) return [0, smallest];
  const room = Math.max((high - low) * 0.08, (smallest - (high - low)) / 2, 1e-9);
  return [low - room, high + room];
}

/** Always the common window: an automatic scale could span from 1970 to now. */
function timeScale(): [number, number] {
  const [from, to] = shown();
  return Number.isFinite(to) ? [from, to] : [0, window_s()];
}

function timeSplits(plot: uPlot): number[] {
  const { min = 0, max = 0 } = plot.scales.x ?? {};
  const steps = [5, 10, 20, 30, 60, 120, 300];
  const most = Math.max(2, plot.width / 60);
  const step = steps.find((s) => (max - min) / s <= most) ?? 600;
  const origin = Number.isFinite(history.missionStart) ? history.missionStart : max;
  const ticks: number[] = [];
  for (let k = Math.ceil((min - origin) / step); origin + k * step <= max; k++) ticks.push(origin + k * step);
  return ticks;
}

function axisTexts(ticks: number[], heading: boolean): string[] {
  const step = Math.abs((ticks[1] ?? 1) - (ticks[0] ?? 0));
  const decimals = Math.min(3, Math.max(0, Math.ceil(-Math.log10(step || 1) - 1e-9)));
  return ticks.map((tick) => (heading ? headingOf : fixed)(tick, decimals));
}

/** Mode as a faint ground under the lines. */
function shade(plot: uPlot): void {
  const { top, height } = plot.bbox;
  const g = plot.ctx;
  g.save();
  for (const { mode, left, width } of modeBoxes(plot)) {
    g.fillStyle = modeLook(mode).colour;
    g.globalAlpha = 0.13;
    g.fillRect(left, top, width, height);
    g.globalAlpha = 0.9;
    g.fillRect(left, top, width, 2 * devicePixelRatio);
  }
  g.restore();
}

/** The mode's letter above the lines: colour never alone. */
function letter(plot: uPlot): void {
  const g = plot.ctx;
  const scale = devicePixelRatio;
  g.save();
  g.font = `700 ${10 * scale}px system-ui, sans-serif`;
  g.textBaseline = "top";
  g.textAlign = "left";
  g.fillStyle = colour("--ink");
  for (const { mode, left, width } of modeBoxes(plot)) {
    if (width > 14 * scale) g.fillText(modeLook(mode).letter, left + 4 * scale, plot.bbox.top + 5 * scale);
  }
  g.restore();
}

function modeBoxes(plot: uPlot): { mode: Mode; left: number; width: number }[] {
  const { min, max } = plot.scales.x ?? {};
  if (min == null || max == null) return [];
  const at = (time: number): number =>
    plot.bbox.left + ((Math.min(Math.max(time, min), max) - min) / (max - min)) * plot.bbox.width;
  return spans(min, max)
    .filter(({ mode }) => mode !== Mode.UNSPECIFIED)
    .map(({ mode, start, end }) => ({ mode, left: at(start), width: at(end) - at(start) }));
}
