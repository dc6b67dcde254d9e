// Figures of every run against the first, and what the runs were flown with where it is not the same.
import { fixed, signed } from "../lib/format";
import { type Comparison, letterOf } from "./compared";

const CHANGES = { better: "better", worse: "worse", same: "same", "": "" } as const;
const MARKS = { better: "▲", worse: "▼", same: "=", "": "" } as const;

export function FiguresTable({ comparison: { runs, figures } }: { comparison: Comparison }) {
  return (
    <table class="table compact" aria-label="Figures">
      <thead>
        <tr>
          <th scope="col">Figure</th>
          {runs.map((run, k) => (
            <th key={run.id} scope="col" class="num">
              {letterOf(k)}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {figures.map((figure) => (
          <tr key={figure.key} title={figure.about}>
            <th scope="row">
              {figure.label} <span class="unit">{figure.unit}</span>
            </th>
            {figure.values.map((value, k) => {
              const change = figure.changes[k] ?? "";
              const base = figure.values[0];
              const apart = k && value != null && base != null ? value - base : undefined;
              return (
                <td key={runs[k]?.id} class="num" data-change={change || undefined}>
                  {fixed(value, figure.decimals)}
                  {apart !== undefined && change !== "same" && (
                    <span class="apart"> {signed(apart, figure.decimals)}</span>
                  )}
                  {change && (
                    <span class="change-mark">
                      {" "}
                      <span aria-hidden="true">{MARKS[change]}</span>
                      <span class="sr">{CHANGES[change]}</span>
                    </span>
                  )}
                </td>
              );
            })}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

export function SettingsTable({ comparison: { runs, settings } }: { comparison: Comparison }) {
  return (
    <table class="table compact" aria-label="What differs">
      <thead>
        <tr>
          <th scope="col">Entry</th>
          {runs.map((run, k) => (
            <th key={run.id} scope="col">
              {letterOf(k)}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {settings.map((row) => (
          <tr key={`${row.kind}/${row.name}`}>
            <th scope="row">
              <span class="tag">{row.kind}</span> <span class="code">{row.name}</span>
            </th>
            {row.values.map((value, k) => (
              <td key={runs[k]?.id} class="code setting">
                {value.length > 60 ? `${value.slice(0, 57)}…` : value}
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
