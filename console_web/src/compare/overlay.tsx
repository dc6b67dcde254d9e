// One signal of all compared runs in one plot, from the moment they are aligned on.
import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { fixed, placesOf } from "../lib/format";
import { colour, font, theme, typeSize } from "../lib/theme";
import { type Comparison, DASHES, letterOf, lines, type Moment, rows } from "./compared";

interface OverlayProps {
  column: string;
  title: string;
  unit: string;
  downward?: boolean;
  align: Moment;
  comparison: Comparison;
}

export function Overlay({ column, title, unit, downward, align, comparison }: OverlayProps) {
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = box.current;
    if (!element) return;
    let plot: uPlot | undefined;
    const stop = effect(() => {
      void [theme.value, typeSize.value];
      plot?.destroy();
      plot = undefined;
      if (!rows.value.length) return;
      const moments = comparison.runs.map((run) => run.moments as Record<string, number>);
      const data = lines(rows.value, moments, align, column);
      plot = new uPlot(
        options(element, rows.value.length, downward ?? false),
        data as uPlot.AlignedData,
        element,
      );
    });
    const size = new ResizeObserver(() => {
      if (element.clientWidth) plot?.setSize({ width: element.clientWidth, height: element.clientHeight });
    });
    size.observe(element);
    return () => {
      size.disconnect();
      stop();
      plot?.destroy();
    };
  }, [column, align, comparison]);
  return (
    <figure class="overlay" aria-label={`${title} of all runs${unit && `, ${unit}`}`}>
      <figcaption>
        <b>{title}</b> <span class="unit">{unit}</span>
        <span class="grow" />
        {comparison.runs.map((run, k) => (
          <span key={run.id} class="run-key" data-run={k}>
            {letterOf(k)}
          </span>
        ))}
      </figcaption>
      <div class="overlay-box" ref={box} />
    </figure>
  );
}

function options(element: HTMLElement, count: number, downward: boolean): uPlot.Options {
  const em = typeSize.peek() * 0.8;
  const axis = { stroke: colour("--ink-2"), font: font("--text-2xs"), ticks: { show: false } };
  const grid = { stroke: colour("--grid"), width: 1 };
  return {
    width: Math.max(60, element.clientWidth),
    height: Math.max(40, element.clientHeight),
    legend: { show: false },
    cursor: { sync: { key: "compare" }, drag: { x: true, y: false } },
    scales: { x: { time: false }, y: { dir: downward ? -1 : 1 } },
    axes: [
      { ...axis, grid, size: 1.6 * em, gap: 2, values: (_, at) => at.map((t) => fixed(t, 0)) },
      {
        ...axis,
        grid,
        size: 3.7 * em,
        gap: 3,
        space: 1.7 * em,
        values: (_, at) => at.map((mark) => fixed(mark, placesOf(Math.abs((at[1] ?? 1) - (at[0] ?? 0))))),
      },
    ],
    series: [
      {},
      ...Array.from({ length: count }, (_, k) => ({
        stroke: colour(`--run-${k + 1}`),
        width: 1.6,
        dash: DASHES[k] ?? [],
        points: { show: false },
        spanGaps: false,
      })),
    ],
  };
}
