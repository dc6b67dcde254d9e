// The box of one chart, its title and its values.
import { useEffect, useRef } from "preact/hooks";
import { chart } from "./chart";
import "./plot.css";
import type { PlotSpec } from "./plots";

export function Plot({ spec, axis }: { spec: PlotSpec; axis: boolean }) {
  const box = useRef<HTMLDivElement>(null);
  const values = useRef<HTMLSpanElement>(null);
  useEffect(
    () => (box.current ? chart(box.current, values.current, spec, axis) : undefined),
    [spec.id, axis],
  );
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
