// Second line, on every view: what flies, how far it is, and the four commands. Abort stands
// apart at the far end and wants to be held.
import { MissionPhase } from "../gen/bumpless_pb";
import { missions } from "../api/resources";
import { clock } from "../lib/format";
import { isFlying, linkNow, PHASES, phaseNow } from "../live/link_state";
import { useFrame } from "../stream/frame";
import { live } from "../stream/store";
import { HoldButton } from "../ui/hold_button";
import { PauseIcon, PlayIcon, StopIcon } from "../ui/icons";
import { ProblemTable, RefusalNotice } from "../ui/refusal";
import { choose, command, commandState, startChosen } from "./commands";

const PHASE_LOOKS: Partial<Record<MissionPhase, string>> = {
  [MissionPhase.RUNNING]: "running",
  [MissionPhase.PAUSED]: "paused",
  [MissionPhase.COMPLETED]: "completed",
  [MissionPhase.ABORTED]: "aborted",
};

export function CommandBar() {
  useFrame();
  const phase = phaseNow();
  const flying = isFlying(phase);
  const reachable = linkNow().look === "live" || linkNow().look === "stale";
  const busy = commandState.busy !== undefined;
  const paused = phase === MissionPhase.PAUSED;
  return (
    <>
      <section class="commandbar" aria-label="Mission control">
        <Progress />
        <span class="grow" />
        {!flying && <Chooser disabled={!reachable || busy} />}
        {flying && (
          <button
            type="button"
            class="action"
            disabled={!reachable || busy}
            onClick={() => void command(paused ? "resume" : "pause")}
          >
            {paused ? <PlayIcon /> : <PauseIcon />} {paused ? "Resume" : "Pause"}
          </button>
        )}
        <HoldButton
          name="Abort mission"
          class="abort"
          holdMs={1000}
          disabled={!flying || !reachable}
          title={flying ? "Press and hold for one second to end the mission now" : "No mission is running"}
          onHeld={() => void command("abort")}
        >
          <StopIcon /> Hold to abort
        </HoldButton>
      </section>
      {commandState.notice && (
        <div class="command-notice">
          <RefusalNotice
            title={commandState.notice.title}
            refusal={commandState.notice.refusal}
            onClose={() => {
              commandState.notice = undefined;
            }}
          />
          {commandState.notice.refusal.problems.length > 0 && (
            <ProblemTable problems={commandState.notice.refusal.problems} />
          )}
        </div>
      )}
    </>
  );
}

function Progress() {
  const status = live.latest("tlm/mission");
  const phase = phaseNow();
  const flying = isFlying(phase);
  const share = status && status.durationS > 0 ? Math.min(1, status.elapsedS / status.durationS) : 0;
  return (
    <div class="mission-now" data-state={live.isFresh("tlm/mission") ? "fresh" : "stale"}>
      <span class="chip phase" data-look={PHASE_LOOKS[phase] ?? "idle"} role="status" aria-label="Mission phase">
        {PHASES[phase]}
      </span>
      {status?.missionName ? (
        <>
          <span class="mission-name" title={`Run ${status.runId || "–"}, seed ${status.seed}`}>
            {status.missionName}
          </span>
          {flying && (
            <>
              <span class="num">
                <span class="sr">Mission time </span>T+{clock(status.elapsedS)}
                <span class="muted"> / {clock(status.durationS)}</span>
              </span>
              <span class="progress" role="progressbar" aria-label="Share of the planned duration"
                aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(share * 100)}>
                <i style={{ width: `${(share * 100).toFixed(1)}%` }} />
              </span>
            </>
          )}
          {!flying && status.endReason && <span class="muted ellipsis" title={status.endReason}>{status.endReason}</span>}
        </>
      ) : (
        <span class="muted">
          {phase === MissionPhase.UNSPECIFIED ? "Waiting for the vehicle." : "No mission loaded. Choose one and start it."}
        </span>
      )}
    </div>
  );
}

function Chooser({ disabled }: { disabled: boolean }) {
  const list = missions.use().value ?? [];
  if (!commandState.chosen && list[0]) commandState.chosen = list[0].name;
  const badSeed = commandState.seed.trim() !== "" && !/^\d{1,9}$/.test(commandState.seed.trim());
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
        value={commandState.chosen}
        onChange={(event) => choose(event.currentTarget.value)}
      >
        {list.length === 0 && <option value="">No missions</option>}
        {list.map((mission) => (
          <option key={mission.name} value={mission.name}>
            {mission.title || mission.name}
          </option>
        ))}
      </select>
      <label class="seed">
        <span class="muted">Seed</span>
        <input
          inputMode="numeric"
          placeholder="auto"
          aria-invalid={badSeed}
          title="Seed of the simulated sensors and sea; empty: the mission's own"
          value={commandState.seed}
          onInput={(event) => {
            commandState.seed = event.currentTarget.value;
          }}
        />
      </label>
      <button type="submit" class="action primary" disabled={disabled || !commandState.chosen || badSeed}>
        <PlayIcon /> {commandState.busy === "start" ? "Starting" : "Start"}
      </button>
    </form>
  );
}
