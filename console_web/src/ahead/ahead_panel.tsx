// What the draft would do from here, before it is applied: lines, a track from above, and figures.
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { fixed, signed } from "../lib/format";
import { colour, font } from "../lib/theme";
import { href } from "../shell/address";
import { history } from "../stream/history";
import { shownFlying } from "../stream/screen";
import { ActButton } from "../ui/act_button";
import { Canvas } from "../ui/canvas";
import { Empty, Panel } from "../ui/panel";
import { RefusalIn } from "../ui/refusal";
import "../ui/table.css";
import { draft } from "../weights/draft";
import { jsonOfFlat } from "../weights/flat";
import "./ahead_panel.css";
import {
  type AheadFlight,
  ahead,
  flyAhead,
  flying,
  HORIZONS_S,
  horizon_s,
  isOther,
  refused,
} from "./flights";

/** Fly again by itself after each edit. */
const follows = signal(true);
const QUIET_MS = 400;

type Figures = AheadFlight["figures"];
const FIGURES: { key: keyof Figures; name: string; unit: string; decimals: number; less: boolean }[] = [
  { key: "depth_error_max_m", name: "Depth error, largest", unit: "m", decimals: 3, less: true },
  { key: "cross_track_max_m", name: "Cross-track, largest", unit: "m", decimals: 3, less: true },
  { key: "residual_rms", name: "Residual RMS", unit: "N, N·m", decimals: 4, less: true },
  { key: "command_step_max", name: "Largest command step", unit: "of bounds", decimals: 4, less: true },
  { key: "saturated_share", name: "Cycles at a bound", unit: "", decimals: 3, less: true },
  { key: "range_end_m", name: "Range at the end", unit: "m", decimals: 2, less: false },
];
const LINES = [
  { column: "depth", name: "Depth", unit: "m", downward: true },
  { column: "speed", name: "Surge speed", unit: "m/s", downward: false },
  { column: "yaw", name: "Heading", unit: "°", downward: false },
  { column: "residual", name: "Residual norm", unit: "", downward: false },
];

/** Why nothing can be flown ahead; "" when it can. */
function whyNotAhead(): string {
  if (!shownFlying.value) return "No mission is being flown";
  if (draft.invalid.value.size > 0) return "A field of the draft holds no number";
  return draft.changedPaths.value.length ? "" : "The draft has no change";
}

export function AheadPanel() {
  const parameters = jsonOfFlat(draft.whole());
  const changed = draft.changedPaths.value.length > 0 && draft.invalid.value.size === 0;
  const can = changed && shownFlying.value;
  const whyNot = flying.value ? "It is being flown ahead" : whyNotAhead();
  const asked = JSON.stringify(parameters);
  useEffect(() => {
    if (!can || !follows.value) return;
    const timer = setTimeout(() => void flyAhead(parameters), QUIET_MS);
    return () => clearTimeout(timer);
  }, [can, asked, horizon_s.value, follows.value]);
  const answer = ahead.value;
  return (
    <Panel
      title="What if"
      class="ahead"
      aside={
        <>
          <label class="ahead-follow">
            <input
              type="checkbox"
              checked={follows.value}
              onChange={(event) => {
                follows.value = event.currentTarget.checked;
              }}
            />
            after each edit
          </label>
          <select
            class="small"
            aria-label="How far ahead"
            value={horizon_s.value}
            onChange={(event) => {
              horizon_s.value = Number(event.currentTarget.value);
            }}
          >
            {HORIZONS_S.map((s) => (
              <option key={s} value={s}>
                {s} s
              </option>
            ))}
          </select>
          <ActButton class="action small" why={whyNot} onAct={() => void flyAhead(parameters)}>
            {flying.value ? "Flying" : "Fly ahead"}
          </ActButton>
        </>
      }
    >
      <RefusalIn title="Not flown." of={refused} />
      {!answer && (
        <Empty>
          {shownFlying.value
            ? "Change something: the draft is flown from where the vehicle is, and nothing is applied."
            : "While a mission is flown, a draft can be seen here before it is applied."}
        </Empty>
      )}
      {answer && (
        <>
          <p class="ahead-what" role="status">
            From T+{fixed(answer.from_s, 1)} s, over revision {answer.revision}.{" "}
            {isOther(parameters) && <strong>Of another draft than the one beside. </strong>}
            <a href={href("live")}>See it in Live</a>
          </p>
          <p class="ahead-key">
            <span class="ahead-line" data-look="as-it-is" /> as it is{" "}
            <span class="ahead-line" data-look="draft" /> draft
          </p>
          <div class="ahead-lines">
            {LINES.map((line) => (
              <Line key={line.column} {...line} />
            ))}
            <figure class="ahead-plot">
              <figcaption>
                <b>Track</b> <span class="unit">from above, north up</span>
              </figcaption>
              <Canvas class="ahead-canvas" name="Tracks ahead from above" paint={paintTrack} />
            </figure>
          </div>
          <FiguresTable one={answer.as_it_is} other={answer.draft} />
        </>
      )}
    </Panel>
  );
}

function FiguresTable({ one, other }: { one: AheadFlight; other: AheadFlight }) {
  return (
    <table class="table compact" aria-label="Figures ahead">
      <thead>
        <tr>
          <th scope="col">Ahead</th>
          <th scope="col" class="num">
            As it is
          </th>
          <th scope="col" class="num">
            Draft
          </th>
        </tr>
      </thead>
      <tbody>
        {FIGURES.map(({ key, name, unit, decimals, less }) => {
          const apart = other.figures[key] - one.figures[key];
          const same = fixed(one.figures[key], decimals) === fixed(other.figures[key], decimals);
          return (
            <tr key={key}>
              <th scope="row">
                {name} <span class="unit">{unit}</span>
              </th>
              <td class="num">{fixed(one.figures[key], decimals)}</td>
              <td class="num" data-change={same || !less ? undefined : apart < 0 ? "better" : "worse"}>
                {fixed(other.figures[key], decimals)}
                {!same && <span class="apart"> {signed(apart, decimals)}</span>}
                {!same && less && <span class="sr"> {apart < 0 ? "better" : "worse"}</span>}
              </td>
            </tr>
          );
        })}
        <tr>
          <th scope="row">Switches</th>
          <td class="num">{switchesOf(one)}</td>
          <td class="num">{switchesOf(other)}</td>
        </tr>
      </tbody>
    </table>
  );
}

function switchesOf({ switches }: AheadFlight): string {
  return switches.map((s) => `${s.from}→${s.to} ${fixed(s.time_s, 1)} s`).join(", ") || "none";
}

interface LineProps {
  column: string;
  name: string;
  unit: string;
  downward: boolean;
}

function Line({ column, name, unit, downward }: LineProps) {
  return (
    <figure class="ahead-plot">
      <figcaption>
        <b>{name}</b> <span class="unit">{unit}</span>
      </figcaption>
      <Canvas
        class="ahead-canvas"
        name={`${name} ahead, as it is and with the draft`}
        paint={(g, width, height) => paintLine(g, width, height, column, downward)}
      />
    </figure>
  );
}

type Points = [number, number][];

function pointsOf(flight: AheadFlight, column: string): Points {
  const values = flight.columns[column] ?? [];
  return flight.time_s.flatMap((t, i): Points => {
    const value = values[i];
    return value == null ? [] : [[t, value]];
  });
}

function paintLine(
  g: CanvasRenderingContext2D,
  width: number,
  height: number,
  column: string,
  downward: boolean,
): void {
  const answer = ahead.peek();
  if (!answer) return;
  const flown = measured(column, answer.from_s, Math.max(0.1, answer.from_s - 0.25 * horizon_s.peek()));
  draw(
    g,
    width,
    height,
    [
      { points: flown, ink: colour("--trace"), dash: [] },
      { points: pointsOf(answer.as_it_is, column), ink: colour("--ink-2"), dash: [6, 4] },
      { points: pointsOf(answer.draft, column), ink: colour("--run-2"), dash: [6, 4] },
    ],
    downward,
    false,
  );
}

/** What was flown before, as far as the page knows. */
function measured(column: string, to: number, from: number): Points {
  const values = history.column(column);
  const start = history.missionStart;
  const found: Points = [];
  for (let i = history.firstIndex(start + from); i < history.firstIndex(start + to); i++) {
    const value = values?.[i];
    if (value !== undefined && !Number.isNaN(value)) found.push([(history.time[i] as number) - start, value]);
  }
  return found;
}

function paintTrack(g: CanvasRenderingContext2D, width: number, height: number): void {
  const answer = ahead.peek();
  if (!answer) return;
  const track = ({ columns }: AheadFlight): Points =>
    (columns.east ?? []).map((east, i) => [east ?? 0, columns.north?.[i] ?? 0]);
  draw(
    g,
    width,
    height,
    [
      { points: track(answer.as_it_is), ink: colour("--ink-2"), dash: [6, 4] },
      { points: track(answer.draft), ink: colour("--run-2"), dash: [6, 4] },
    ],
    false,
    true,
  );
}

interface Drawn {
  points: Points;
  ink: string;
  dash: number[];
}

/** Lines to one scale with their limits written at the edges; `square`: both axes to the same scale. */
function draw(
  g: CanvasRenderingContext2D,
  width: number,
  height: number,
  lines: Drawn[],
  downward: boolean,
  square: boolean,
): void {
  const all = lines.flatMap(({ points }) => points);
  if (!all.length) return;
  const xs = all.map(([x]) => x);
  const ys = all.map(([, y]) => y);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const pad = 4;
  let sx = (width - 2 * pad) / Math.max(x1 - x0, 1e-6);
  let sy = (height - 2 * pad) / Math.max(y1 - y0, 0.02 * (Math.abs(y0) + 1));
  if (square)
    sx = sy = Math.min((width - 2 * pad) / Math.max(x1 - x0, 1), (height - 2 * pad) / Math.max(y1 - y0, 1));
  const at = ([x, y]: [number, number]): [number, number] => [
    width / 2 + (x - (x0 + x1) / 2) * sx,
    height / 2 + (y - (y0 + y1) / 2) * sy * (downward ? 1 : -1),
  ];
  for (const { points, ink, dash } of lines) {
    g.strokeStyle = ink;
    g.lineWidth = 1.7;
    g.setLineDash(dash);
    g.beginPath();
    for (const point of points) g.lineTo(...at(point));
    g.stroke();
  }
  g.setLineDash([]);
  if (square) return;
  g.fillStyle = colour("--ink-2");
  g.font = font("--text-3xs");
  const [top, bottom] = downward ? [y0, y1] : [y1, y0];
  g.textBaseline = "top";
  g.fillText(fixed(top, 2), 2, 1);
  g.textBaseline = "bottom";
  g.fillText(fixed(bottom, 2), 2, height - 1);
}
