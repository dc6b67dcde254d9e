// Faults and outages by time, under the modes that will fly then: bars are dragged, whole or by an end.
import { fixed } from "../../lib/format";
import { plan } from "../fly/forecast";
import { vehicle } from "../map/figures";
import { EVENTS, type EventKind } from "../model/event_kinds";
import { addEvent } from "../model/events";
import { niceStep } from "../model/geometry";
import type { PlanEvent } from "../model/mission";
import { edit, mission } from "../model/plan";
import { EVENT_PATHS } from "../model/things";
import { Bar } from "./bar";
import { lasts, share } from "./scale";
import "./timeline.css";

const ADD: readonly { kind: EventKind; words: string; about: string }[] = [
  { kind: "fault", words: "Fault", about: "An actuator loses its force" },
  { kind: "outage", words: "Sight", about: "A time in which the target isn't seen" },
  { kind: "dvl", words: "Doppler log", about: "A time without bottom track" },
];
const TICKS = 8;

export function Timeline() {
  const { events } = mission.value;
  const count = EVENTS.reduce((sum, kind) => sum + events[kind].length, 0);
  return (
    <section class="panel timeline" aria-label="Faults and outages" data-empty={count === 0 ? "yes" : "no"}>
      <header class="panel-head">
        <h2>Faults and outages</h2>
        <span class="unit">s</span>
        <span class="grow" />
        <span class="muted small-text">Add</span>
        {ADD.map(({ kind, words, about }) => (
          <button
            key={kind}
            type="button"
            class="action small"
            title={about}
            aria-label={kind === "fault" ? "Add a fault" : `Add an outage: ${words}`}
            onClick={() => addEvent(kind, soon(), vehicle.peek()?.actuators[0] ?? "")}
          >
            {words}
          </button>
        ))}
      </header>
      {count > 0 && (
        <div class="timeline-body">
          <Axis />
          {EVENTS.flatMap((kind) =>
            events[kind].map((event, i) => <Lane key={`${kind}:${i}`} kind={kind} index={i} event={event} />),
          )}
        </div>
      )}
    </section>
  );
}

/** When a new one begins: as the approach does, or a third of the way. */
function soon(): number {
  const nominal = plan.forecast.peek()?.nominal;
  const turns = nominal?.switches.find(({ to }) => to === "R")?.t_s;
  return Math.round(turns ?? lasts.peek() / 3);
}

function Axis() {
  const nominal = plan.current.value ? plan.forecast.value?.nominal : undefined;
  const step = niceStep(lasts.value / TICKS);
  const ticks = Array.from({ length: Math.floor(lasts.value / step) + 1 }, (_, i) => i * step);
  return (
    <div class="lane axis">
      <span class="lane-name muted">Mode</span>
      <div class="lane-water">
        {nominal && <Modes t={nominal.track.t_s} mode={nominal.track.mode} />}
        {ticks.map((t) => (
          <span key={t} class="tick num" style={{ left: share(t) }}>
            {t}
          </span>
        ))}
      </div>
    </div>
  );
}

function Modes({ t, mode }: { t: readonly number[]; mode: readonly string[] }) {
  const runs: { mode: string; from: number; to: number }[] = [];
  mode.forEach((letter, i) => {
    const last = runs.at(-1);
    const at = t[i] ?? 0;
    if (last?.mode === letter) last.to = at;
    else {
      if (last) last.to = at;
      runs.push({ mode: letter, from: at, to: at });
    }
  });
  return (
    <>
      {runs.map((run) => (
        <i
          key={run.from}
          class="mode-run"
          data-mode={run.mode}
          style={{ left: share(run.from), width: share(run.to - run.from) }}
        />
      ))}
    </>
  );
}

function Lane({ kind, index, event }: { kind: EventKind; index: number; event: PlanEvent }) {
  return (
    <div class="lane">
      {kind === "fault" ? (
        <Actuator index={index} of={event.of} />
      ) : (
        <span class="lane-name">{kind === "dvl" ? "Doppler log" : "Sight"}</span>
      )}
      <div class="lane-water">
        <Bar kind={kind} index={index} event={event} name={nameOf(kind, event)} />
      </div>
    </div>
  );
}

function nameOf(kind: EventKind, { of, from, to, left }: PlanEvent): string {
  if (kind === "fault") return `Fault of ${of} from ${fixed(from, 1)} s, ${fixed(100 * left, 0)} % left`;
  const what = kind === "dvl" ? "No bottom track" : "Target not seen";
  return `${what} from ${fixed(from, 1)} to ${fixed(to, 1)} s`;
}

function Actuator({ index, of }: { index: number; of: string }) {
  const known = vehicle.value?.actuators ?? [];
  return (
    <select
      class="small lane-name"
      aria-label={`Actuator of fault ${index + 1}`}
      value={of}
      onChange={(event) =>
        edit("Another actuator", [
          { path: [...EVENT_PATHS.fault, index, "actuator"], value: event.currentTarget.value },
        ])
      }
    >
      {!known.includes(of) && <option value={of}>{of || "choose"}</option>}
      {known.map((id) => (
        <option key={id} value={id}>
          {id}
        </option>
      ))}
    </select>
  );
}
