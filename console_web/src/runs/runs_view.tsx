// Runs: each flight's record, newest first, and the chosen run's metrics.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { address as addressOf } from "../api/client";
import { runs, runsDisk } from "../api/resources";
import type { RunSummary } from "../api/types";
import { CompareView } from "../compare/compare_view";
import { MOST } from "../compare/compared";
import { bytes, clock, dateTime } from "../lib/format";
import { address, go } from "../shell/address";
import { ActButton } from "../ui/act_button";
import { ENDINGS } from "../ui/endings";
import { DownloadIcon } from "../ui/icons";
import { Main } from "../ui/main";
import { Empty, Panel } from "../ui/panel";
import "../ui/table.css";
import { TakeBack } from "./bin";
import { BringIn, DropArea } from "./bring_in";
import { DiskUse } from "./disk_use";
import { isPiece, shownRuns } from "./filter";
import { OutcomeChip } from "./outcome";
import { RunDetails } from "./run_details";
import { useNow } from "./run_now";
import { SavedViews } from "./saved_views";
import "./runs_view.css";

export function RunsView() {
  return address.value.query.compare === undefined ? <List /> : <CompareView />;
}

function List() {
  useEffect(() => {
    void runs.refresh();
    void runsDisk.refresh();
  }, []);
  const { value: list, refusal } = runs;
  const words = useSignal("");
  const outcome = useSignal("");
  const marked = useSignal<readonly string[]>([]);
  const sorted = shownRuns(list ?? [], { words: words.value, outcome: outcome.value });
  const run = list?.find(({ id }) => id === address.value.id) ?? sorted[0];
  const mark = (id: string): void => {
    const without = marked.value.filter((other) => other !== id);
    marked.value = without.length < marked.value.length ? without : [...without, id].slice(-MOST);
  };
  return (
    <Main name="Runs" class="view runs">
      <Panel
        title="Runs"
        class="run-list"
        aside={
          <>
            <input
              type="search"
              aria-label="Search in runs"
              placeholder="Search"
              value={words.value}
              onInput={(event) => {
                words.value = event.currentTarget.value;
              }}
            />
            <select
              class="small"
              aria-label="Outcome"
              value={outcome.value}
              onChange={(event) => {
                outcome.value = event.currentTarget.value;
              }}
            >
              <option value="">all outcomes</option>
              {Object.entries(ENDINGS).map(([value, { word }]) => (
                <option key={value} value={value}>
                  {word}
                </option>
              ))}
            </select>
            <SavedViews
              filter={{ words: words.value, outcome: outcome.value }}
              onChoose={(next) => {
                words.value = next.words;
                outcome.value = next.outcome;
              }}
            />
            <BringIn />
            <ActButton
              class="action small"
              why={marked.value.length < 2 ? "Mark two to six runs in the list first" : ""}
              onAct={() => go("runs", "", { compare: marked.value.join() })}
            >
              Compare {marked.value.length || ""}
            </ActButton>
            <span class="muted num">{sorted.length || ""}</span>
          </>
        }
      >
        <DropArea>
          <TakeBack />
          {refusal && <Empty>The list cannot be read: {refusal.reason}</Empty>}
          {list && list.length > 0 && !sorted.length && <Empty>No run is like that.</Empty>}
          {!refusal && list && !list.length && (
            <Empty>No runs yet. Start a mission: it is recorded from start to end. Or drop a log here.</Empty>
          )}
          {sorted.length > 0 && (
            <table class="table">
              <thead>
                <tr>
                  <th scope="col">
                    <span class="sr">Mark to compare</span>
                  </th>
                  <th scope="col">Outcome</th>
                  <th scope="col">Mission</th>
                  <th scope="col" class="num">
                    Recorded
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
                  <Row
                    key={item.id}
                    run={item}
                    chosen={item === run}
                    marked={marked.value.includes(item.id)}
                    onMark={() => mark(item.id)}
                    onChoose={() => go("runs", item.id)}
                  />
                ))}
              </tbody>
            </table>
          )}
          <DiskUse />
        </DropArea>
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

interface RowProps {
  run: RunSummary;
  chosen: boolean;
  marked: boolean;
  onMark: () => void;
  onChoose: () => void;
}

function Row({ run, chosen, marked, onMark, onChoose }: RowProps) {
  const now = useNow(run);
  return (
    <tr data-chosen={chosen ? "yes" : undefined} onClick={onChoose}>
      <td>
        <input
          type="checkbox"
          aria-label={`Mark ${run.id} to compare`}
          checked={marked}
          disabled={run.state === "recording"}
          title={run.state === "recording" ? "A run being recorded can't be compared yet" : undefined}
          onClick={(event) => event.stopPropagation()}
          onChange={onMark}
        />
      </td>
      <td>
        <OutcomeChip run={run} />
      </td>
      <td>
        <button type="button" class="link" aria-pressed={chosen} title={run.id} onClick={onChoose}>
          {run.title || run.mission || run.id}
        </button>
        {isPiece(run) && <span class="tag">piece {run.id.slice(run.run_id.length + 1)}</span>}
        {run.tags.map((tag) => (
          <span key={tag} class="tag">
            {tag}
          </span>
        ))}
      </td>
      <td class="num">{dateTime(run.recorded)}</td>
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
