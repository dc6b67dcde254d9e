// Runs: each flight's record, newest first, and the chosen run's metrics.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { address as addressOf } from "../api/client";
import { runs, runsDisk } from "../api/resources";
import type { RunSummary } from "../api/types";
import { CompareView } from "../compare/compare_view";
import { MOST } from "../compare/compared";
import { address, go } from "../shell/address";
import { ActButton } from "../ui/act_button";
import { ENDINGS } from "../ui/endings";
import { DownloadIcon } from "../ui/icons";
import { Main } from "../ui/main";
import { Empty, Panel } from "../ui/panel";
import "../ui/table.css";
import { TakeBack } from "./bin";
import { BringIn, DropArea } from "./bring_in";
import { COLUMNS } from "./columns";
import { DiskUse } from "./disk_use";
import { shownFlights } from "./filter";
import { asOne, type Flight, flightsOf } from "./flights";
import { columns, outcome, runViews, show, words } from "./list_state";
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
    void runViews.refresh();
  }, []);
  const { value: list, refusal } = runs;
  const marked = useSignal<readonly string[]>([]);
  const sorted = shownFlights(list ?? [], { words: words.value, outcome: outcome.value });
  const { id: asked } = address.value;
  const found = flightsOf(list ?? []).find(({ pieces }) => pieces.some(({ id }) => id === asked));
  const gone = list !== undefined && asked !== "" && !found;
  const flight = found ?? (gone ? undefined : sorted[0]);
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
                outcome.value = event.currentTarget.value as typeof outcome.value;
              }}
            >
              <option value="">all outcomes</option>
              <option value="recording">recording</option>
              {Object.entries(ENDINGS).map(([value, { word }]) => (
                <option key={value} value={value}>
                  {word}
                </option>
              ))}
            </select>
            <SavedViews />
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
          {list && list.length > 0 && !sorted.length && (
            <Empty>
              No run is like that.{" "}
              <button type="button" class="action small" onClick={() => show(undefined)}>
                Show all runs
              </button>
            </Empty>
          )}
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
                  {columns.value.map((column) => (
                    <th
                      key={column}
                      scope="col"
                      class={COLUMNS[column].num ? "num" : ""}
                      title={COLUMNS[column].about}
                    >
                      {COLUMNS[column].name}
                    </th>
                  ))}
                  <th scope="col">
                    <span class="sr">Download</span>
                  </th>
                </tr>
              </thead>
              <tbody>
                {sorted.map((item) => (
                  <Row
                    key={item.head.id}
                    flight={item}
                    chosen={item.head.id === flight?.head.id}
                    marked={marked.value.includes(item.head.id)}
                    onMark={() => mark(item.head.id)}
                    onChoose={() => go("runs", item.head.id)}
                  />
                ))}
              </tbody>
            </table>
          )}
          <DiskUse />
        </DropArea>
      </Panel>
      {flight ? (
        <RunDetails key={flight.head.id} flight={flight} />
      ) : (
        <Panel title="Run">
          <Empty>
            {gone
              ? `There is no run ${asked} here: it was deleted, or another server has it.`
              : "The metrics of the chosen run appear here."}
          </Empty>
        </Panel>
      )}
    </Main>
  );
}

interface RowProps {
  flight: Flight;
  chosen: boolean;
  marked: boolean;
  onMark: () => void;
  onChoose: () => void;
}

function Row({ flight, chosen, marked, onMark, onChoose }: RowProps) {
  const { head, pieces, flown, growing, holds } = flight;
  const now = useNow(flight);
  const one: RunSummary = { ...asOne(flight), duration_s: now.duration_s ?? null, bytes: now.bytes };
  const shown = growing ? { ...flight, head: one, pieces: [one] } : flight;
  return (
    <tr data-chosen={chosen ? "yes" : undefined} onClick={onChoose}>
      <td>
        <input
          type="checkbox"
          aria-label={`Mark ${head.id} to compare`}
          checked={marked}
          aria-disabled={head.state === "recording"}
          title={head.state === "recording" ? "A run being recorded can't be compared yet" : undefined}
          onClick={(event) => {
            event.stopPropagation();
            if (head.state === "recording") event.preventDefault();
          }}
          onChange={onMark}
        />
      </td>
      <td>
        <OutcomeChip run={asOne(flight)} />
      </td>
      <td>
        <button type="button" class="link" aria-pressed={chosen} title={head.id} onClick={onChoose}>
          {head.title || head.mission || head.id}
        </button>
        {pieces.length > 1 && flown.length !== 1 && (
          <span class="tag" title="One flight that was recorded in pieces">
            {pieces.length} pieces
          </span>
        )}
        {holds && <span class="tag">hold recorded</span>}
        {head.tags.map((tag) => (
          <span key={tag} class="tag">
            {tag}
          </span>
        ))}
      </td>
      {columns.value.map((column) => (
        <td
          key={column}
          class={COLUMNS[column].num ? "num" : "words-cell ellipsis"}
          title={COLUMNS[column].whole?.(flight)}
        >
          {COLUMNS[column].of(shown)}
        </td>
      ))}
      <td>
        {pieces.length === 1 && (
          <a
            class="action small"
            href={addressOf("/api/runs/{run}/log.mcap", { run: head.id })}
            download={`${head.id}.mcap`}
            aria-label={`Download ${head.id} as MCAP`}
            onClick={(event) => event.stopPropagation()}
          >
            <DownloadIcon size={12} />
          </a>
        )}
      </td>
    </tr>
  );
}
