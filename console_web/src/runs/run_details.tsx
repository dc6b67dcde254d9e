// One run: how it ended, its metrics, its file, and its deletion.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { address, ask } from "../api/client";
import type { Answer, Refusal } from "../api/http";
import { runs } from "../api/resources";
import type { Metrics, RunSummary } from "../api/types";
import { bytes, clock, dateTime } from "../lib/format";
import { HoldButton } from "../ui/hold_button";
import { DownloadIcon, TrashIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import { RefusalNotice } from "../ui/refusal";
import "../ui/facts.css";
import { MetricsTables } from "./metrics_tables";
import { OutcomeChip } from "./outcome";
import { useNow } from "./run_now";
import "./run_details.css";

/** Asked for once the run has ended: until then there are none. */
function useMetrics(run: RunSummary): Answer<Metrics> | undefined {
  const answer = useSignal<Answer<Metrics> | undefined>(undefined);
  useEffect(() => {
    answer.value = undefined;
    if (run.state === "recording") return;
    let current = true;
    void ask("get", "/api/runs/{run}/metrics", { path: { run: run.id } }).then((got) => {
      if (current) answer.value = got;
    });
    return () => {
      current = false;
    };
  }, [run.id, run.state, Boolean(run.metrics)]);
  return answer.value;
}

export function RunDetails({ run }: { run: RunSummary }) {
  const metrics = useMetrics(run);
  const now = useNow(run);
  return (
    <div class="column">
      <Panel
        title={run.mission || "Run"}
        class="run-about"
        aside={
          <>
            <OutcomeChip run={run} />
            <a
              class="action"
              href={address("/api/runs/{run}/log.mcap", { run: run.id })}
              download={`${run.id}.mcap`}
            >
              <DownloadIcon /> Download MCAP
            </a>
            <Delete run={run} />
          </>
        }
      >
        <dl class="facts wide">
          <div>
            <dt>Run</dt>
            <dd class="code">{run.id}</dd>
          </div>
          <div>
            <dt>Started</dt>
            <dd class="num">{dateTime(run.started)}</dd>
          </div>
          <div>
            <dt>Duration</dt>
            <dd class="num">{clock(now.duration_s)}</dd>
          </div>
          <div>
            <dt>Size</dt>
            <dd class="num">{bytes(now.bytes)}</dd>
          </div>
          <div>
            <dt>Ended</dt>
            <dd class="sentence">
              {run.state === "recording" ? "still flying" : run.outcome_reason || run.end_reason || "–"}
            </dd>
          </div>
        </dl>
      </Panel>
      <Panel title="Metrics" class="run-metrics">
        {run.state === "recording" && <Empty>Metrics are computed when the run ends.</Empty>}
        {metrics?.ok === false && <Empty>No metrics: {metrics.reason}</Empty>}
        {metrics?.ok && <MetricsTables metrics={metrics.value} />}
      </Panel>
    </div>
  );
}

function Delete({ run }: { run: RunSummary }) {
  const refusal = useSignal<Refusal | undefined>(undefined);
  const remove = async (): Promise<void> => {
    const answer = await ask("delete", "/api/runs/{run}", { path: { run: run.id } });
    refusal.value = answer.ok ? undefined : answer;
    await runs.refresh();
  };
  return (
    <>
      <HoldButton
        name={`Delete run ${run.id}`}
        class="danger"
        holdMs={1000}
        disabled={run.state === "recording"}
        title={
          run.state === "recording"
            ? "A run being recorded cannot be deleted"
            : "Press and hold to delete the record for good"
        }
        onHeld={() => void remove()}
      >
        <TrashIcon /> Hold to delete
      </HoldButton>
      {refusal.value && (
        <RefusalNotice
          title="Not deleted."
          refusal={refusal.value}
          onClose={() => {
            refusal.value = undefined;
          }}
        />
      )}
    </>
  );
}
