// Second line, on every view: what flies, how far it is, and the four commands. Abort stands
// apart at the far end and wants to be held.
import { computed } from "@preact/signals";
import { useRef } from "preact/hooks";
import { barred, commands, OBSERVES } from "../access/control";
import { ControlChip } from "../access/control_chip";
import { missions } from "../api/resources";
import { type Event, MissionPhase } from "../gen/bumpless_pb";
import { clock } from "../lib/format";
import { ARRANGEMENTS, arrange, arrangement } from "../live/arrangement";
import { flying, link, moving, phase } from "../stream/link";
import { PHASES } from "../stream/phase";
import { foreign, ownFirst } from "../stream/present";
import { live } from "../stream/store";
import { ActButton } from "../ui/act_button";
import { endingNamed } from "../ui/endings";
import { HoldButton } from "../ui/hold_button";
import { PauseIcon, PlayIcon, RiseIcon, StopIcon } from "../ui/icons";
import { useKeptFocus } from "../ui/keep_focus";
import { ProblemTable, RefusalNotice } from "../ui/refusal";
import { Segments } from "../ui/segments";
import "./command_bar.css";
import {
  busy,
  choosing,
  chosen,
  command,
  misfit,
  mission,
  notice,
  seed,
  seedRefused,
  startChosen,
  waits,
} from "./commands";
import { view } from "./views";

/** The view with a start of its own, by what it shows: a second one beside it would fly something else. */
const STARTS_ITSELF = "plan";
const PHASE_LOOKS: Partial<Record<MissionPhase, string>> = {
  [MissionPhase.RUNNING]: "running",
  [MissionPhase.PAUSED]: "paused",
  [MissionPhase.COMPLETED]: "idle",
  [MissionPhase.ABORTED]: "aborted",
};

export function CommandBar() {
  const bar = useRef<HTMLElement>(null);
  useKeptFocus(bar);
  const reachable = link.value.look === "live" || link.value.look === "stale";
  const why = (reachable ? "" : "No live vehicle") || waits.value;
  const paused = phase.value === MissionPhase.PAUSED;
  return (
    <>
      <section class="commandbar" aria-label="Mission control" ref={bar}>
        <Progress />
        <ControlChip />
        {view.value === "live" && (
          <span data-aside>
            <Segments
              name="Arrangement"
              choices={ARRANGEMENTS}
              chosen={arrangement.value}
              onChoose={arrange}
            />
          </span>
        )}
        {!flying.value && view.value !== STARTS_ITSELF && <Chooser why={why || barred.value} />}
        {flying.value && (
          <ActButton
            class="action"
            why={why || (commands.value ? "" : OBSERVES) || (paused ? barred.value : "")}
            title={paused ? "Go on with the mission" : "Brake and hold station here; the mission waits"}
            onAct={() => void command(paused ? "resume" : "pause")}
          >
            {paused ? <PlayIcon /> : <PauseIcon />} {paused ? "Resume" : "Hold"}
          </ActButton>
        )}
        {inControl.value && (
          <HoldButton
            name="Surface"
            class="surface"
            holdMs={600}
            why={why || barred.value}
            title="Press and hold: gives the mission a rest and holds at the surface; it can be resumed"
            onHeld={() => void command("surface")}
          >
            <RiseIcon /> Surface
          </HoldButton>
        )}
        <HoldButton
          name="Abort mission"
          class="abort"
          holdMs={1000}
          why={whyNoAbort()}
          title="Press and hold for one second: stops all actuators. The vehicle then drifts, and rises where it is buoyant."
          onHeld={() => void command("abort")}
        >
          <StopIcon /> Hold to abort
        </HoldButton>
      </section>
      <Refused />
    </>
  );
}

/** A mission is flown, or is over and station is held: there is somebody who can bring it up. */
const inControl = computed(() => flying.value || phase.value === MissionPhase.COMPLETED);

/** While an actuator may move, it can be aborted. */
function whyNoAbort(): string {
  if (!moving.value) return "All actuators are at rest";
  if (link.value.look === "offline") return "The server does not answer";
  return commands.value ? "" : OBSERVES;
}

function Refused() {
  if (!notice.value) return null;
  const { title, refusal } = notice.value;
  const close = (): void => {
    notice.value = undefined;
  };
  return (
    <div class="command-notice">
      <RefusalNotice title={title} refusal={refusal} onClose={close} />
      {refusal.problems.length > 0 && <ProblemTable problems={refusal.problems} />}
    </div>
  );
}

/** The server's judgement of the run that has just ended, once it has come. */
function judged(runId: string | undefined): Event | undefined {
  if (flying.value || !runId) return undefined;
  return live.events.find(({ code, details }) => code === "outcome" && details.run?.startsWith(runId));
}

/** "Docked: held in hover ..." without the word that stands before it already. */
function withoutWord(text: string, word: string): string {
  const rest = word && text.toLowerCase().startsWith(`${word}: `) ? text.slice(word.length + 2) : text;
  return capital(rest);
}

function capital(word: string): string {
  return word.charAt(0).toUpperCase() + word.slice(1);
}

function Progress() {
  const status = live.latest("tlm/mission");
  const outcome = judged(status?.runId);
  const ending = endingNamed(outcome?.details.ending);
  const ended = withoutWord(outcome?.text ?? status?.endReason ?? "", ending?.word ?? "");
  return (
    <div class="mission-now" data-state={live.isFresh("tlm/mission") ? "fresh" : "stale"}>
      <span
        class="chip phase"
        data-look={ending?.look ?? PHASE_LOOKS[phase.value] ?? "idle"}
        title={flying.value ? undefined : ended || undefined}
        role="status"
        aria-label="Mission phase"
      >
        {ending ? (
          <>
            <ending.Icon size={11} /> {capital(ending.word)}
          </>
        ) : (
          PHASES[phase.value]
        )}
      </span>
      {!status?.missionName && (
        <span class="muted ellipsis">
          {phase.value === MissionPhase.UNSPECIFIED ? "Waiting for the vehicle." : "No mission loaded."}
        </span>
      )}
      {status?.missionName && (
        <span class="mission-name ellipsis" title={`Run ${status.runId || "–"}, seed ${status.seed}`}>
          {status.missionName}
        </span>
      )}
      {status?.missionName && flying.value && (
        <Elapsed elapsedS={status.elapsedS} durationS={status.durationS} heldS={status.heldS} />
      )}
      <After />
      {status?.missionName && !flying.value && ended && (
        <span class="muted ellipsis why-ended" title={ended}>
          {ended}
        </span>
      )}
    </div>
  );
}

/** What the vehicle does once its mission is over. */
function After() {
  if (phase.value === MissionPhase.COMPLETED) {
    return (
      <span class="chip" data-look="running" title="Actuators run until it is told otherwise">
        Holding station
      </span>
    );
  }
  if (phase.value !== MissionPhase.ABORTED) return null;
  return (
    <span
      class="chip"
      data-look={moving.value ? "stale" : "off"}
      title="Nothing holds the vehicle: it drifts, and rises where it is buoyant"
    >
      {moving.value ? "Actuators are stopping" : "Actuators stopped: drifting"}
    </span>
  );
}

/** The clock goes on in a pause, and is told to; the share of the plan stands still. */
function Elapsed({ elapsedS, durationS, heldS }: { elapsedS: number; durationS: number; heldS: number }) {
  const planned = durationS - heldS;
  const share = planned > 0 ? Math.max(0, Math.min(1, (elapsedS - heldS) / planned)) : 0;
  return (
    <>
      <span class="num">
        <span class="sr">Mission time </span>T+{clock(elapsedS)}
        <span class="muted"> / {clock(durationS)}</span>
        {heldS > 0 && <span class="muted">, held for {clock(heldS)}</span>}
      </span>
      <span
        class="progress"
        role="progressbar"
        aria-label="Share of the planned duration"
        aria-valuemin={0}
        aria-valuemax={100}
        aria-valuenow={Math.round((share || 0) * 100)}
      >
        <i style={{ width: `${(share * 100).toFixed(1)}%` }} />
      </span>
    </>
  );
}

/** Why what is chosen can't be started; "" when it can. */
function whyNoStart(): string {
  if (choosing.value) return "Another mission is being opened";
  if (!mission.value) return "No mission is chosen";
  if (misfit.value) return `This mission is for ${misfit.value}`;
  return seedRefused.value ? "The seed is no whole number" : "";
}

function Chooser({ why }: { why: string }) {
  const list = ownFirst(missions.value ?? []);
  return (
    <form
      class="chooser"
      onSubmit={(event) => {
        event.preventDefault();
        void startChosen();
      }}
    >
      <select
        aria-label="Mission"
        value={mission.value}
        onChange={(event) => {
          chosen.value = event.currentTarget.value;
        }}
      >
        {list.length === 0 && <option value="">No missions</option>}
        {list.map((one) => (
          <option key={one.name} value={one.name} disabled={foreign(one)}>
            {one.title || one.name}
            {foreign(one) && ` (for ${one.vehicle})`}
          </option>
        ))}
      </select>
      <label class="seed">
        <span class="muted">Seed</span>
        <input
          inputMode="numeric"
          aria-label="Seed"
          placeholder="auto"
          aria-invalid={seedRefused.value}
          title="Seed of the simulated sensors and sea; empty: the mission's own"
          value={seed.value}
          onInput={(event) => {
            seed.value = event.currentTarget.value;
          }}
        />
      </label>
      <ActButton type="submit" class="action primary" why={why || whyNoStart()}>
        <PlayIcon /> {busy.value === "start" ? "Starting" : "Start"}
      </ActButton>
    </form>
  );
}
