// One run: how it ended, its metrics, its file, and its deletion.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { address, ask } from "../api/client";
import type { Answer } from "../api/http";
import { runs } from "../api/resources";
import type { RunSummary } from "../api/types";
import type { components } from "../gen/api";
import { bytes, clock, dateTime, fixed } from "../lib/format";
import { go, href } from "../shell/address";
import { DeleteButton } from "../ui/delete_button";
import { DownloadIcon, PlayIcon, WarningIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import "../ui/facts.css";
import { throwAway } from "./bin";
import { ExportForm } from "./export_form";
import { asOne, type Flight } from "./flights";
import { FlyAgain } from "./fly_again";
import { MetricsTables } from "./metrics_tables";
import { OutcomeChip } from "./outcome";
import { useNow } from "./run_now";
import { WordsForm } from "./words_form";
import "./run_details.css";

type Whole = components["schemas"]["FlightAnswer"];

/** Over all files of the flight; asked for once one has ended: until then there is nothing to tell. */
function useWhole({ head, pieces }: Flight): Answer<Whole> | undefined {
  const answer = useSignal<Answer<Whole> | undefined>(undefined);
  const state = pieces.map(({ id, state }) => id + state).join();
  useEffect(() => {
    answer.value = undefined;
    if (head.state === "recording") return;
    let current = true;
    void ask("get", "/api/runs/{run}/flight", { path: { run: head.id } }).then((got) => {
      if (current) answer.value = got;
    });
    return () => {
      current = false;
    };
  }, [head.id, state]);
  return answer.value;
}

export function RunDetails({ flight }: { flight: Flight }) {
  const whole = useWhole(flight);
  const now = useNow(flight);
  const { head, pieces } = flight;
  const told = whole?.ok ? whole.value : undefined;
  const one = asOne(flight);
  const run = one.state === "recording" || !told?.outcome ? one : { ...one, ...verdict(told) };
  return (
    <div class="column">
      <Panel
        title={run.title || run.mission || "Run"}
        class="run-about"
        aside={
          <>
            <OutcomeChip run={run} />
            {head.state !== "recording" && (
              <a class="action small primary" href={href("runs", run.id, { t: 0 })}>
                <PlayIcon size={12} /> Replay
              </a>
            )}
            {pieces.length === 1 && (
              <a
                class="action small"
                href={address("/api/runs/{run}/log.mcap", { run: run.id })}
                download={`${run.id}.mcap`}
              >
                <DownloadIcon size={12} /> Download MCAP
              </a>
            )}
            {head.state !== "recording" && (
              <a
                class="action small"
                href={address("/api/runs/{run}/report.html", { run: run.id })}
                target="_blank"
                rel="noopener"
                title="One HTML file to send or print; fetches nothing"
              >
                Report
              </a>
            )}
            <Delete flight={flight} />
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
        {told && <Gaps flight={told} />}
        {head.state !== "recording" && <WordsForm key={run.id} run={head} />}
        {pieces.length > 1 && <Pieces flight={flight} told={told} />}
        <ExportForm pieces={pieces} />
        {head.state !== "recording" && <FlyAgain run={head} />}
      </Panel>
      <Panel title="Metrics" class="run-metrics" scrolls>
        {head.state === "recording" && <Empty>Metrics are computed when the run ends.</Empty>}
        {whole?.ok === false && <Empty>No metrics: {whole.reason}</Empty>}
        {told && !told.metrics && <Empty>No metrics: the log holds too little of a mission.</Empty>}
        {told?.metrics && run.state === "recording" && (
          <Empty>Up to the last piece that is over: the flight is still being recorded.</Empty>
        )}
        {told?.metrics && <MetricsTables metrics={told.metrics} />}
      </Panel>
    </div>
  );
}

function verdict({ outcome, outcome_reason }: Whole): Partial<RunSummary> {
  return { outcome, outcome_reason };
}

/** What was not recorded: what happened there, nobody knows, and no figure holds it. */
function Gaps({ flight: { gaps } }: { flight: Whole }) {
  if (!gaps.length) return null;
  const lost = gaps.reduce((all, { first_s, last_s }) => all + (last_s ?? 0) - (first_s ?? 0), 0);
  return (
    <p class="gaps">
      <WarningIcon size={12} /> {fixed(lost, 1)} s of it were not recorded (
      {gaps.map(({ first_s, last_s }) => `T+${clock(first_s)} to ${clock(last_s)}`).join(", ")}). Figures are
      of the rest.
    </p>
  );
}

/** The files that a flight was recorded in: the mission, what a crash cut off, the hold after it. */
function Pieces({ flight: { pieces }, told }: { flight: Flight; told: Whole | undefined }) {
  return (
    <table class="table compact pieces" aria-label="Files of this flight">
      <tbody>
        {pieces.map((piece) => {
          const held = told?.pieces.find(({ id }) => id === piece.id);
          return (
            <tr key={piece.id}>
              <th scope="row">{piece.piece}</th>
              <td class="num">
                {held?.first_s == null ? "–" : `T+${clock(held.first_s)} to ${clock(held.last_s)}`}
              </td>
              <td class="piece-end">
                {piece.state === "recording"
                  ? "being recorded"
                  : piece.outcome
                    ? "mission: "
                    : "hold after it "}
                {(piece.outcome || piece.state !== "complete") && (
                  <span class="muted">{piece.end_reason}</span>
                )}
              </td>
              <td>
                <a
                  class="action small"
                  href={address("/api/runs/{run}/log.mcap", { run: piece.id })}
                  download={`${piece.id}.mcap`}
                  aria-label={`Download ${piece.id} as MCAP`}
                >
                  <DownloadIcon size={12} /> {bytes(piece.bytes)}
                </a>
              </td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

function Delete({ flight: { head, pieces, growing } }: { flight: Flight }) {
  const all = pieces.length > 1 ? `, all ${pieces.length} files,` : "";
  return (
    <DeleteButton
      name={`Delete run ${head.id}`}
      holdMs={1000}
      why={growing ? "A run being recorded cannot be deleted" : ""}
      title={`Press and hold to put the record${all} into the bin`}
      remove={() => throwAway(pieces.map(({ id }) => id))}
      after={(gone) => {
        if (gone) go("runs", "", {}, true);
        return runs.refresh();
      }}
    />
  );
}
