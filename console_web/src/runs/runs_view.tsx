// Runs: each flight's record, newest first, and the chosen run's metrics.
import { useEffect } from "preact/hooks";
import { address as addressOf } from "../api/client";
import { runs } from "../api/resources";
import type { RunSummary } from "../api/types";
import { bytes, clock, dateTime } from "../lib/format";
import { address, go } from "../shell/address";
import { DownloadIcon } from "../ui/icons";
import { Main } from "../ui/main";
import { Empty, Panel } from "../ui/panel";
import "../ui/table.css";
import { OutcomeChip } from "./outcome";
import { RunDetails } from "./run_details";
import { useNow } from "./run_now";
import "./runs_view.css";

export function RunsView() {
  useEffect(() => void runs.refresh(), []);
  const { value: list, refusal } = runs;
  const sorted = [...(list ?? [])].sort((a, b) => b.id.localeCompare(a.id));
  const run = sorted.find(({ id }) => id === address.value.id) ?? sorted[0];
  return (
    <Main name="Runs" class="view runs">
      <Panel title="Runs" class="run-list" aside={<span class="muted num">{sorted.length || ""}</span>}>
        {refusal && <Empty>The list cannot be read: {refusal.reason}</Empty>}
        {!refusal && list && !sorted.length && (
          <Empty>No runs yet. Start a mission: it is recorded from start to end.</Empty>
        )}
        {sorted.length > 0 && (
          <table class="table">
            <thead>
              <tr>
                <th scope="col">Outcome</th>
                <th scope="col">Mission</th>
                <th scope="col" class="num">
                  Started
                </th>
                <th scope="col" class="num">
                  Duration
                </th>
                <th scope="col" class="num">
                  Size
                </th>
                <th scope="col">
                  <span class="sr">Download</span>
                </th>
              </tr>
            </thead>
            <tbody>
              {sorted.map((item) => (
                <Row key={item.id} run={item} chosen={item === run} onChoose={() => go("runs", item.id)} />
              ))}
            </tbody>
          </table>
        )}
      </Panel>
      {run ? (
        <RunDetails key={run.id} run={run} />
      ) : (
        <Panel title="Run">
          <Empty>The metrics of the chosen run appear here.</Empty>
        </Panel>
      )}
    </Main>
  );
}

function Row({ run, chosen, onChoose }: { run: RunSummary; chosen: boolean; onChoose: () => void }) {
  const now = useNow(run);
  return (
    <tr data-chosen={chosen ? "yes" : undefined} onClick={onChoose}>
      <td>
        <OutcomeChip run={run} />
      </td>
      <td>
        <button type="button" class="link" aria-pressed={chosen} title={run.id} onClick={onChoose}>
          {run.mission || run.id}
        </button>
      </td>
      <td class="num">{dateTime(run.started)}</td>
      <td class="num">{clock(now.duration_s)}</td>
      <td class="num">{bytes(now.bytes)}</td>
      <td>
        <a
          class="action small"
          href={addressOf("/api/runs/{run}/log.mcap", { run: run.id })}
          download={`${run.id}.mcap`}
          aria-label={`Download ${run.id} as MCAP`}
          onClick={(event) => event.stopPropagation()}
        >
          <DownloadIcon size={12} /> MCAP
        </a>
      </td>
    </tr>
  );
}
