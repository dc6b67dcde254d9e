// A run for another program: whole or a range, as a log, a table of signals, or MOOS' own format.
import { useSignal } from "@preact/signals";
import { address } from "../api/client";
import type { RunSummary } from "../api/types";
import { DownloadIcon } from "../ui/icons";

const KINDS = [
  { value: "mcap", name: "MCAP", about: "Opens in Foxglove, Lichtblick and any MCAP reader" },
  { value: "csv", name: "CSV", about: "One row per cycle" },
  { value: "parquet", name: "Parquet", about: "One row per cycle, for pandas, Arrow and DuckDB" },
  { value: "alog", name: ".alog", about: "For MOOS-IvP's tools" },
] as const;
type Kind = (typeof KINDS)[number]["value"];
const NUMBER = /^\s*-?\d+([.,]\d+)?\s*$/;

export function ExportForm({ pieces }: { pieces: readonly RunSummary[] }) {
  const file = useSignal(pieces[0]?.id ?? "");
  const kind = useSignal<Kind>("mcap");
  const from = useSignal("");
  const to = useSignal("");
  const signals = useSignal("");
  const table = kind.value === "csv" || kind.value === "parquet";
  const [first, last] = [numberOf(from.value), numberOf(to.value)];
  const broken =
    (from.value.trim() !== "" && first === undefined) ||
    (to.value.trim() !== "" && last === undefined) ||
    (first !== undefined && last !== undefined && first > last);
  const query = new URLSearchParams({ as: kind.value });
  if (first !== undefined) query.set("from_s", String(first));
  if (last !== undefined) query.set("to_s", String(last));
  if (table) for (const name of signals.value.split(/[\s,]+/).filter(Boolean)) query.append("signal", name);
  const href = `${address("/api/runs/{run}/export", { run: file.value })}?${query}`;
  const about = KINDS.find(({ value }) => value === kind.value)?.about;
  return (
    <fieldset class="export">
      <legend class="sr">Export</legend>
      {pieces.length > 1 && (
        <label>
          <span class="muted">File</span>
          <select
            class="small"
            aria-label="File to export"
            value={file.value}
            onChange={(event) => {
              file.value = event.currentTarget.value;
            }}
          >
            {pieces.map(({ id, piece }) => (
              <option key={id} value={id}>
                {piece}
              </option>
            ))}
          </select>
        </label>
      )}
      <label>
        <span class="muted">As</span>
        <select
          class="small"
          aria-label="Export as"
          value={kind.value}
          title={about}
          onChange={(event) => {
            kind.value = event.currentTarget.value as Kind;
          }}
        >
          {KINDS.map(({ value, name }) => (
            <option key={value} value={value}>
              {name}
            </option>
          ))}
        </select>
      </label>
      <label>
        <span class="muted">from</span>
        <input
          class="num"
          aria-label="From, mission time in seconds"
          placeholder="start"
          inputMode="decimal"
          value={from.value}
          onInput={(event) => {
            from.value = event.currentTarget.value;
          }}
        />
      </label>
      <label>
        <span class="muted">to</span>
        <input
          class="num"
          aria-label="To, mission time in seconds"
          placeholder="end"
          inputMode="decimal"
          value={to.value}
          onInput={(event) => {
            to.value = event.currentTarget.value;
          }}
        />
        <span class="unit">s</span>
      </label>
      {table && (
        <label class="export-signals">
          <span class="muted">Signals</span>
          <input
            aria-label="Signals of the table"
            placeholder="all, or navigation.* control.demanded.x_n"
            value={signals.value}
            onInput={(event) => {
              signals.value = event.currentTarget.value;
            }}
          />
        </label>
      )}
      {broken ? (
        <span class="lost" role="status">
          From and to must be seconds, in this order.
        </span>
      ) : (
        <a class="action small" href={href} download>
          <DownloadIcon size={12} /> Export
        </a>
      )}
      <a class="action small" href="api/foxglove_layout.json" download title="A layout for our logs">
        Foxglove layout
      </a>
    </fieldset>
  );
}

function numberOf(text: string): number | undefined {
  return NUMBER.test(text) ? Number(text.trim().replace(",", ".")) : undefined;
}
