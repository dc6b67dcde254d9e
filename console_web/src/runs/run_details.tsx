// One run: how it ended, its metrics, its file, and its deletion.
import { fromJson, type JsonValue } from "@bufbuild/protobuf";
import { useEffect, useState } from "preact/hooks";
import { request, type Refusal } from "../api/http";
import { runs } from "../api/resources";
import type { RunSummary } from "../api/types";
import { MetricsSchema, type Metrics } from "../gen/bumpless_pb";
import { bytes, clock, dateTime } from "../lib/format";
import { HoldButton } from "../ui/hold_button";
import { DownloadIcon, TrashIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import { RefusalNotice } from "../ui/refusal";
import { MetricsTables } from "./metrics_tables";
import { RunState, useNow } from "./run_state";

function parse(json: unknown): Metrics | undefined {
  if (!json || typeof json !== "object") return undefined;
  return fromJson(MetricsSchema, json as JsonValue, { ignoreUnknownFields: true });
}

/** Metrics from the list when they are there, else asked for once the run has ended. */
function useMetrics(run: RunSummary): { metrics?: Metrics; refusal?: Refusal } {
  const [answer, setAnswer] = useState<{ metrics?: Metrics; refusal?: Refusal }>({});
  useEffect(() => {
    if (run.state === "recording") return setAnswer({});
    let current = true;
    void request<unknown>("GET", `api/runs/${encodeURIComponent(run.id)}/metrics`).then((got) => {
      if (current) setAnswer(got.ok ? { metrics: parse(got.value) } : { refusal: got });
    });
    return () => {
      current = false;
    };
  }, [run.id, run.state, Boolean(run.metrics)]);
  return answer;
}

export function RunDetails({ run }: { run: RunSummary }) {
  const { metrics, refusal } = useMetrics(run);
  const now = useNow(run);
  return (
    <div class="column">
      <Panel
        title={run.mission || "Run"}
        class="run-about"
        aside={
          <>
            <RunState state={run.state} />
            <a class="action" href={`api/runs/${encodeURIComponent(run.id)}/log.mcap`} download={`${run.id}.mcap`}>
              <DownloadIcon /> Download MCAP
            </a>
            <Delete run={run} />
          </>
        }
      >
        <dl class="facts wide">
          <div><dt>Run</dt><dd class="code">{run.id}</dd></div>
          <div><dt>Started</dt><dd class="num">{dateTime(run.started)}</dd></div>
          <div><dt>Duration</dt><dd class="num">{clock(now.duration_s)}</dd></div>
          <div><dt>Size</dt><dd class="num">{bytes(now.bytes)}</dd></div>
          <div><dt>Ended</dt><dd>{run.state === "recording" ? "still flying" : run.end_reason || "–"}</dd></div>
        </dl>
      </Panel>
      <Panel title="Metrics" class="run-metrics">
        {run.state === "recording" && <Empty>Metrics are computed when the run ends.</Empty>}
        {refusal && <Empty>No metrics: {refusal.reason}</Empty>}
        {metrics && <MetricsTables metrics={metrics} />}
      </Panel>
    </div>
  );
}

function Delete({ run }: { run: RunSummary }) {
  const [refusal, setRefusal] = useState<Refusal>();
  const remove = async (): Promise<void> => {
    const answer = await request("DELETE", `api/runs/${encodeURIComponent(run.id)}`);
    setRefusal(answer.ok ? undefined : answer);
    await runs.refresh();
  };
  return (
    <>
      <HoldButton name={`Delete run ${run.id}`} class="danger" holdMs={1000} disabled={run.state === "recording"}
        title={run.state === "recording" ? "A run being recorded cannot be deleted" : "Press and hold to delete the record for good"}
        onHeld={() => void remove()}>
        <TrashIcon /> Hold to delete
      </HoldButton>
      {refusal && <RefusalNotice title="Not deleted." refusal={refusal} onClose={() => setRefusal(undefined)} />}
    </>
  );
}
