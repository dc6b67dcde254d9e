// A uPlot chart outside the component tree: it is made anew when its look changes, fed when there is news.
import { effect } from "@preact/signals";
import uPlot from "uplot";
import { ahead } from "../ahead/flights";
import { drawAhead, extent } from "../ahead/overlay";
import { fixed, headingOf, placesOf } from "../lib/format";
import { colour, font, theme, typeSize } from "../lib/theme";
import { heldAt, screen } from "../stream/screen";
import { marks } from "./event_marks";
import { ghost, ghostLine } from "./ghost";
import { band } from "./limit_band";
import { limits } from "./limits";
import { letter, shade } from "./mode_ground";
import { pace } from "./pace";
import type { PlotSpec } from "./plots";
import { follow, shown, showStretch, ticks, timeLabel, window_s } from "./time_axis";

/** Draw `spec` into `box` from now on, its values into `values`; returns how to stop. */
export function chart(
  box: HTMLElement,
  values: HTMLElement | null,
  spec: PlotSpec,
  axis: boolean,
): () => void {
  let plot: uPlot | undefined;
  let seen = box.clientHeight > 0; // asking the box with each picture would lay the page out once more
  const stopMaking = effect(() => {
    void [theme.value, typeSize.value];
    plot?.destroy();
    plot = new uPlot(options(spec, axis, box.clientWidth, box.clientHeight), dataOf(spec), box);
  });
  const due = pace();
  let drawn: unknown[] = [];
  const stopFeeding = effect(() => {
    const asked = [window_s.value, heldAt.value, ghost.value, limits.value, ahead.value, plot];
    void screen.tick;
    if (!plot || !seen) return;
    if (due(plot.width) || asked.some((one, i) => one !== drawn[i])) {
      drawn = asked;
      plot.setData(dataOf(spec));
    }
    if (values) showValues(values, spec, plot);
  });
  const size = new ResizeObserver(() => {
    seen = box.clientWidth > 0 && box.clientHeight > 0;
    if (seen) plot?.setSize({ width: box.clientWidth, height: box.clientHeight });
  });
  size.observe(box);
  return () => {
    size.disconnect();
    stopFeeding();
    stopMaking();
    plot?.destroy();
  };
}

/** The rows in the window, and the one before it so that lines enter from the edge. */
function dataOf(spec: PlotSpec): uPlot.AlignedData {
  const [from, to] = shown();
  const first = Math.max(0, screen.history.firstIndex(from) - 1);
  const rows = Math.max(0, screen.history.firstIndex(to + 1e-6) - first);
  const lines = spec.traces.map(({ column }) => {
    const values = screen.history.column(column);
    const line: (number | null)[] = new Array(rows).fill(null);
    for (let i = 0; values && i < rows; i++) {
      const value = values[first + i] as number;
      if (!Number.isNaN(value)) line[i] = value;
    }
    return line;
  });
  const times = screen.history.time.slice(first, first + rows);
  const measured = spec.traces.find(({ look }) => look === "measured")?.column ?? "";
  const near = spec.heading ? screen.history.column(measured)?.subarray(first, first + rows) : undefined;
  return [times, ...lines, ghost.value ? ghostLine(measured, times, near) : new Array(rows).fill(null)];
}

function rowOf(column: string, row: number): number | null {
  const value = screen.history.column(column)?.[row] ?? Number.NaN;
  return Number.isNaN(value) ? null : value;
}

/** Values under the cursor, else the newest. */
function showValues(element: HTMLElement, spec: PlotSpec, plot: uPlot): void {
  const index = plot.cursor.idx;
  const newest = screen.history.firstIndex(screen.until + 1e-6) - 1;
  spec.traces.forEach((trace, i) => {
    const value = index == null ? rowOf(trace.column, newest) : plot.data[i + 1]?.[index];
    const text = (spec.heading ? headingOf : fixed)(value, spec.decimals);
    const part = element.querySelector(`.value-${trace.look}`);
    if (part && part.textContent !== text) part.textContent = text;
  });
}

function options(spec: PlotSpec, axis: boolean, width: number, height: number): uPlot.Options {
  const em = typeSize.peek() * 0.8;
  const common = { stroke: colour("--ink-2"), font: font("--text-2xs"), ticks: { show: false } };
  const grid = { stroke: colour("--grid"), width: 1 };
  return {
    width: Math.max(60, width),
    height: Math.max(40, height),
    legend: { show: false },
    cursor: {
      sync: { key: "live" },
      drag: { x: screen.isLive, y: false, setScale: false },
      points: { size: 5 },
      y: false,
    },
    padding: [6, 16, axis ? 0 : 5, 0],
    scales: {
      x: { time: false, range: () => timeScale() },
      y: {
        dir: spec.downward ? -1 : 1,
        range: (_, low, high) => span(...held(spec, low, high), spec.smallestSpan),
      },
    },
    axes: [
      {
        ...common,
        grid,
        show: axis,
        size: 1.6 * em,
        gap: 2,
        space: 5 * em,
        splits: (plot) => timeSplits(plot),
        values: (_, times) => times.map((time) => timeLabel(time, screen.until)),
      },
      {
        ...common,
        grid,
        size: 3.7 * em,
        gap: 3,
        space: 2.1 * em,
        values: (_, marks) => axisTexts(marks, spec.heading ?? false),
      },
    ],
    series: [
      {},
      ...spec.traces.map(
        ({ look }): uPlot.Series => ({
          stroke: colour(look === "measured" ? "--trace" : "--reference"),
          width: look === "measured" ? 1.6 : 1.3,
          ...(look === "reference" ? { dash: [5, 4] } : {}),
          points: { show: false },
          spanGaps: false,
        }),
      ),
      { stroke: colour("--ink-2"), width: 1.4, dash: [2, 3], points: { show: false }, spanGaps: false },
    ],
    hooks: {
      drawClear: [shade, (plot) => band(plot, spec)],
      draw: [marks, letter, drawAhead(measuredOf(spec))],
      ready: [(plot) => plot.over.addEventListener("dblclick", follow)],
      setSelect: [chosen],
    },
  };
}

/** A stretch was marked by dragging: show it alone. */
function chosen(plot: uPlot): void {
  const { left, width } = plot.select;
  if (width < 4) return;
  const [from, to] = [plot.posToVal(left, "x"), plot.posToVal(left + width, "x")];
  plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  showStretch(from, to);
}

function measuredOf(spec: PlotSpec): string {
  return spec.traces.find(({ look }) => look === "measured")?.column ?? "";
}

/** The scale holds the flights ahead as well. */
function held(spec: PlotSpec, low: number | null, high: number | null): [number | null, number | null] {
  const ahead = extent(measuredOf(spec));
  if (!ahead || low === null || high === null) return [low, high];
  return [Math.min(low, ahead[0]), Math.max(high, ahead[1])];
}

function span(low: number | null, high: number | null, smallest: number): [number, number] {
  if (low === null || high === null) return [0, smallest];
  const room = Math.max((high - low) * 0.08, (smallest - (high - low)) / 2, 1e-9);
  return [low - room, high + room];
}

/** Always the common window: an automatic scale could span from 1970 to now. */
function timeScale(): [number, number] {
  const [from, to] = shown();
  return Number.isFinite(to) ? [from, to] : [0, window_s.peek()];
}

function timeSplits(plot: uPlot): number[] {
  const { min = 0, max = 0 } = plot.scales.x ?? {};
  const most = Math.max(2, plot.width / (5.4 * typeSize.peek() * 0.8));
  return ticks(min, max, [5, 10, 20, 30, 60, 120, 300].find((s) => (max - min) / s <= most) ?? 600);
}

function axisTexts(marks: number[], heading: boolean): string[] {
  const decimals = placesOf(Math.abs((marks[1] ?? 1) - (marks[0] ?? 0)));
  return marks.map((mark) => (heading ? headingOf : fixed)(mark, decimals));
}
