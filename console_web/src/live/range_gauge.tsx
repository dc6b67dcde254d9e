// Range to the observation point on an axis with the supervisor's five thresholds.
import type { Supervisor } from "../gen/bumpless_pb";
import { fixed } from "../lib/format";
import { inForce } from "../stream/screen";
import { Term } from "../words/term";
import "./range_gauge.css";

interface Threshold {
  value: number;
  text: string;
  about: string;
  row: 0 | 1;
}

function thresholds(s: Supervisor): Threshold[] {
  return [
    { value: s.rangeRhLowerM, text: "R→H", about: "Reverse to hover at or below", row: 0 },
    { value: s.rangeRhUpperM, text: "H→R", about: "Hover to reverse at or above", row: 1 },
    { value: s.rangeFrLowerM, text: "F→R", about: "Forward to reverse at or below", row: 0 },
    { value: s.rangeFrUpperM, text: "R→F", about: "Reverse to forward at or above", row: 1 },
    { value: s.rangeHfUpperM, text: "H→F", about: "Hover to forward at or above", row: 0 },
  ];
}

export function RangeGauge({ supervisor }: { supervisor: Supervisor }) {
  const marks = thresholds(supervisor);
  const top = Math.max(...marks.map((mark) => mark.value)) * 1.3 || 1;
  const range = inForce.value ? supervisor.rangeM : NaN; // before a mission to nothing, after an abort old
  const at = (metres: number): string => `${((100 * Math.min(metres, top)) / top).toFixed(2)}%`;
  const beyond = range > top;
  return (
    <div class="range" role="group" aria-label={`Range to the observation point ${fixed(range, 2)} metres`}>
      <span class="range-value">
        <span class="muted">
          <Term of="range">Range</Term>
        </span>{" "}
        <b class="num">{fixed(range, 2)}</b> m
      </span>
      <div class="range-axis">
        <span class="range-line" />
        {marks.map(({ value, text, about, row }) => (
          <span
            key={text}
            class="threshold"
            data-row={row}
            style={{ left: at(value) }}
            title={`${about} ${fixed(value, 2)} m`}
          >
            <i />
            <span class="threshold-text">
              {text} <span class="num">{fixed(value, 1)}</span>
            </span>
          </span>
        ))}
        {Number.isFinite(range) && (
          <span class="range-mark" data-beyond={beyond ? "yes" : undefined} style={{ left: at(range) }} />
        )}
      </div>
    </div>
  );
}
