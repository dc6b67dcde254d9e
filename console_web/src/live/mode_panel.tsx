// Which mode, why, and what it waits for: the supervisor's state in one panel.

import { MissionPhase, Mode, type Supervisor } from "../gen/bumpless_pb";
import { fixed } from "../lib/format";
import { modeLook } from "../lib/modes";
import { PHASES } from "../stream/phase";
import { inForce, screen, shownMode, shownPhase } from "../stream/screen";
import { HollowIcon, RecordIcon } from "../ui/icons";
import { ModeBadge } from "../ui/mode_mark";
import { Empty, Panel } from "../ui/panel";
import { Term } from "../words/term";
import { DockingLine } from "./docking_line";
import { Exits } from "./exits";
import { ModeStrip } from "./mode_strip";
import { RangeGauge } from "./range_gauge";
import { WINDOWS_S, window_s } from "./time_axis";
import "./mode_panel.css";

export function ModePanel() {
  return (
    <Panel title="Mode" topic="tlm/supervisor" class="mode-panel" aside={<WindowChoice />}>
      <Content />
    </Panel>
  );
}

function WindowChoice() {
  const windows = [...new Set<number>([...WINDOWS_S, window_s.value])].sort((a, b) => a - b);
  return (
    <select
      class="small"
      aria-label="Time window of plots and mode strip"
      value={window_s.value}
      onChange={(event) => {
        window_s.value = Number(event.currentTarget.value);
      }}
    >
      {windows.map((seconds) => (
        <option key={seconds} value={seconds}>
          {seconds < 120
            ? `${fixed(seconds, seconds % 1 ? 1 : 0)} s`
            : `${fixed(seconds / 60, seconds % 60 ? 1 : 0)} min`}
        </option>
      ))}
    </select>
  );
}

/** Beside the mode: how long, what a ramp comes from, or why the mode is not the supervisor's. */
function whatItDoes(supervisor: Supervisor, settled: boolean): string {
  const phase = shownPhase.value;
  if (phase === MissionPhase.ABORTED) return "actuators stopped: drifting";
  if (!inForce.value) return `mission ${PHASES[phase].toLowerCase()}`;
  const ramp = settled ? "" : ` · ${rampWords()}`;
  if (phase === MissionPhase.PAUSED) {
    return `holding station; mission waits in ${modeLook(supervisor.mode).letter}${ramp}`;
  }
  if (phase === MissionPhase.COMPLETED) return `mission over; holding station${ramp}`;
  return `${fixed(supervisor.timeInModeS, 1)} s${ramp || " in mode"}`;
}

/** What the ramp blends from; a page that came during it cannot know. */
function rampWords(): string {
  const from = screen.history.rampFrom;
  if (from === Mode.UNSPECIFIED) return "in transition";
  return from === shownMode.value ? "new settings" : `from ${modeLook(from).letter}`;
}

function Content() {
  const supervisor = screen.latest("tlm/supervisor");
  if (!supervisor)
    return <Empty>The supervisor's mode, range and detection appear with the first telemetry.</Empty>;
  const controlled = inForce.value;
  const mode = modeLook(controlled ? shownMode.value : undefined);
  const running = shownPhase.value === MissionPhase.RUNNING;
  const settled = supervisor.kappa >= 1;
  return (
    <>
      <div class="mode-line">
        <ModeBadge mode={mode} />
        <div class="mode-name">
          <strong>{mode.name}</strong>
          <span class="muted num">{whatItDoes(supervisor, settled)}</span>
        </div>
        <Ramp
          word="kappa"
          label="κ"
          unit=""
          value={controlled ? supervisor.kappa : NaN}
          share={controlled ? supervisor.kappa : 0}
          decimals={2}
          about="Transition factor: 1 when the blend into this mode is over"
        />
        <Dwell remaining={running ? supervisor.dwellRemainingS : NaN} inMode={supervisor.timeInModeS} />
        <div class="lamps" role="group" aria-label="Detection of the target">
          <Lamp
            word="detection_raw"
            name="Raw"
            on={controlled && supervisor.detectionRaw}
            about="Target seen in this cycle"
          />
          <Lamp
            word="detection"
            name="Filtered"
            on={controlled && supervisor.detection}
            about="After the M-of-N filter and hold: what the supervisor uses"
          />
        </div>
      </div>
      <DockingLine supervisor={supervisor} />
      <RangeGauge supervisor={supervisor} />
      <ModeStrip />
      <Exits />
    </>
  );
}

interface RampProps {
  word: "kappa" | "dwell";
  label: string;
  unit: string;
  value: number;
  share: number;
  decimals: number;
  about: string;
}

function Ramp({ word, label, unit, value, share, decimals, about }: RampProps) {
  const width = `${(100 * Math.min(1, Math.max(0, share))).toFixed(1)}%`;
  return (
    <div class="ramp" title={about}>
      <span class="ramp-text">
        <span class="muted">
          <Term of={word}>{label}</Term>
        </span>{" "}
        <b class="num">{fixed(value, decimals)}</b>
        {unit && ` ${unit}`}
      </span>
      <span class="meter">
        <i style={{ width }} />
      </span>
    </div>
  );
}

function Dwell({ remaining, inMode }: { remaining: number; inMode: number }) {
  const whole = remaining + inMode;
  return (
    <Ramp
      word="dwell"
      label="dwell"
      unit="s"
      value={remaining}
      share={remaining > 0 ? remaining / whole : 0}
      decimals={1}
      about="Time until a switch is allowed; 0: allowed now"
    />
  );
}

function Lamp({
  word,
  name,
  on,
  about,
}: {
  word: "detection" | "detection_raw";
  name: string;
  on: boolean;
  about: string;
}) {
  return (
    <span class="lamp" data-on={on ? "yes" : "no"} title={about}>
      {on ? <RecordIcon size={11} /> : <HollowIcon size={11} />} <Term of={word}>{name}</Term>
      <span class="sr">{on ? "detected" : "not detected"}</span>
    </span>
  );
}
