// One run: how it ended, its metrics, its file, and its deletion.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { address, ask } from "../api/client";
import type { Answer } from "../api/http";
import { runs } from "../api/resources";
import type { Metrics, RunSummary } from "../api/types";
import { bytes, clock, dateTime } from "../lib/format";
import { href } from "../shell/address";
import { DeleteButton } from "../ui/delete_button";
import { DownloadIcon, PlayIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import "../ui/facts.css";
import { throwAway } from "./bin";
import { ExportForm } from "./export_form";
import { pieceOf, piecesOf } from "./filter";
import { FlyAgain } from "./fly_again";
import { MetricsTables } from "./metrics_tables";
import { OutcomeChip } from "./outcome";
import { useNow } from "./run_now";
import { WordsForm } from "./words_form";
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
        title={run.title || run.mission || "Run"}
        class="run-about"
        aside={
          <>
            <OutcomeChip run={run} />
            {run.state !== "recording" && (
              <a class="action primary" href={href("runs", run.id, { t: 0 })}>
                <PlayIcon /> Replay
              </a>
            )}
            <a
              class="action"
              href={address("/api/runs/{run}/log.mcap", { run: run.id })}
              download={`${run.id}.mcap`}
            >
              <DownloadIcon /> Download MCAP
            </a>
            {run.state !== "recording" && (
              <a
                class="action"
                href={address("/api/runs/{run}/report.html", { run: run.id })}
                target="_blank"
                rel="noopener"
                title="One HTML file to send or print; fetches nothing"
              >
                Report
              </a>
            )}
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
        {run.state !== "recording" && <WordsForm key={run.id} run={run} />}
        <Pieces run={run} />
        <ExportForm run={run} />
        {run.state !== "recording" && <FlyAgain run={run} />}
      </Panel>
      <Panel title="Metrics" class="run-metrics" scrolls>
        {run.state === "recording" && <Empty>Metrics are computed when the run ends.</Empty>}
        {metrics?.ok === false && <Empty>No metrics: {metrics.reason}</Empty>}
        {metrics?.ok && <MetricsTables metrics={metrics.value} />}
      </Panel>
    </div>
  );
}

/** The pieces that a flight was recorded in: the mission, the hold after it, what a lost link cut. */
function Pieces({ run }: { run: RunSummary }) {
  const pieces = piecesOf(runs.value ?? [], run);
  if (pieces.length < 2) return null;
  return (
    <p class="pieces">
      <span class="muted">One flight in {pieces.length} pieces:</span>
      {pieces.map((piece) => (
        <a
          key={piece.id}
          href={href("runs", piece.id)}
          aria-current={piece.id === run.id ? "true" : undefined}
        >
          {pieceOf(piece)} <span class="num muted">{clock(piece.duration_s)}</span>
        </a>
      ))}
    </p>
  );
}

function Delete({ run }: { run: RunSummary }) {
  return (
    <DeleteButton
      name={`Delete run ${run.id}`}
      holdMs={1000}
      why={run.state === "recording" ? "A run being recorded cannot be deleted" : ""}
      title="Press and hold to put the record into the bin"
      remove={() => throwAway(run.id)}
      after={() => runs.refresh()}
    />
  );
}
