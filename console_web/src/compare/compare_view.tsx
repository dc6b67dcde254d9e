// Runs beside each other: lines laid over each other, figures with better and worse, what differs.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { address, go, href } from "../shell/address";
import { endingNamed } from "../ui/endings";
import { UndoIcon } from "../ui/icons";
import { Main } from "../ui/main";
import { Empty, Panel } from "../ui/panel";
import { Segments } from "../ui/segments";
import "../ui/table.css";
import "./compare_view.css";
import { FiguresTable, SettingsTable } from "./compare_tables";
import { comparison, idsOf, letterOf, load, MOMENTS, type Moment, unread } from "./compared";
import { Ghosts } from "./ghosts";
import { Overlay } from "./overlay";

const SIGNALS = [
  { column: "depth", title: "Depth", unit: "m", downward: true },
  { column: "speed", title: "Surge speed", unit: "m/s" },
  { column: "yaw", title: "Heading", unit: "°" },
  { column: "cross_track", title: "Cross-track", unit: "m" },
  { column: "range", title: "Range", unit: "m" },
  { column: "residual", title: "Residual norm", unit: "" },
] as const;

export function CompareView() {
  const ids = idsOf(address.value.query.compare);
  const align = useSignal<Moment>("start");
  useEffect(() => void load(ids), [ids.join()]);
  const answer = comparison.value;
  return (
    <Main name="Compare runs" class="view compare">
      <Panel
        title="Compared runs"
        class="compared"
        aside={
          <>
            <Segments
              name="Align on"
              choices={MOMENTS}
              chosen={align.value}
              onChoose={(next) => {
                align.value = next;
              }}
            />
            {answer?.ok && (
              <a
                class="action small"
                href={`api/compare/report.html?${new URLSearchParams([...ids.map((id) => ["run", id]), ["align", align.value]])}`}
                target="_blank"
                rel="noopener"
                title="One HTML file to send or print; fetches nothing"
              >
                Report
              </a>
            )}
            <a class="action small" href={href("runs", ids[0])}>
              <UndoIcon size={12} /> Runs
            </a>
          </>
        }
      >
        {answer?.ok === false && <Empty>They cannot be compared: {answer.reason}</Empty>}
        {ids.length < 2 && <Empty>Choose two to six runs in the list to compare them.</Empty>}
        {answer?.ok && (
          <ol class="compared-list">
            {answer.value.runs.map((run, k) => (
              <li key={run.id} data-run={k}>
                <b class="run-key">{letterOf(k)}</b>
                <a href={href("runs", run.id)}>{run.mission || run.id}</a>
                <span class="code muted">{run.id}</span>
                <Ended outcome={run.outcome} reason={run.reason} />
                {k > 0 && (
                  <button
                    type="button"
                    class="action small"
                    onClick={() =>
                      go("runs", "", { compare: [run.id, ...ids.filter((id) => id !== run.id)].join() })
                    }
                  >
                    Compare with this<span class="sr"> run, {letterOf(k)}</span>
                  </button>
                )}
              </li>
            ))}
          </ol>
        )}
      </Panel>
      {answer?.ok && (
        <>
          <Ghosts comparison={answer.value} align={align.value} />
          <Panel title="Lines" class="overlays" scrolls unit={`seconds from ${NAMES[align.value]}`}>
            {unread.value && <Empty>The lines of {unread.value} cannot be read.</Empty>}
            {SIGNALS.map((signal) => (
              <Overlay key={signal.column} {...signal} align={align.value} comparison={answer.value} />
            ))}
          </Panel>
          <Panel title="Figures" class="compared-figures" scrolls unit="against A">
            <FiguresTable comparison={answer.value} />
          </Panel>
          <Panel title="What differs" class="compared-settings" scrolls>
            {answer.value.settings.length ? (
              <SettingsTable comparison={answer.value} />
            ) : (
              <Empty>The same mission, parameters, seed and software.</Empty>
            )}
          </Panel>
        </>
      )}
    </Main>
  );
}

function Ended({ outcome, reason }: { outcome: string; reason: string }) {
  const look = endingNamed(outcome);
  return (
    <>
      <span class="chip" data-look={look?.look ?? "unknown"} title={reason || look?.about}>
        {look && <look.Icon size={11} />} {look?.word ?? "not judged"}
      </span>
      <span class="muted ellipsis compared-why" title={reason}>
        {reason}
      </span>
    </>
  );
}

const NAMES: Record<Moment, string> = {
  start: "the start",
  reverse: "the switch to reverse",
  hover: "the switch to hover",
  end: "the end",
};
