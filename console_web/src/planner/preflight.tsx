// The sheet before a start: what will fly, on what, with what chance, and what abort will do. Held to start.
import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { MissionPhase } from "../gen/bumpless_pb";
import { clock, signed } from "../lib/format";
import { go } from "../shell/address";
import { notice, seed, seedRefused, startShown } from "../shell/commands";
import { flying, link, PHASES, phase } from "../stream/link";
import { live } from "../stream/store";
import { HoldButton } from "../ui/hold_button";
import { AlarmIcon, CheckIcon, CrossIcon, PlayIcon, WarningIcon } from "../ui/icons";
import { RefusalNotice } from "../ui/refusal";
import { hard, plan, soft, told } from "./fly/forecast";
import { othersIn, percent } from "./fly/foresight";
import { vehicle } from "./map/figures";
import { badge, hash, name, save, saving, trouble, unsaved } from "./model/library";
import { table } from "./model/mission";
import { broken, mission, text } from "./model/plan";
import { Ask } from "./preflight_ask";
import { Failsafes } from "./preflight_failsafe";
import { preflight } from "./preflight_state";
import "./preflight.css";

export function Preflight() {
  const sheet = useRef<HTMLDialogElement>(null);
  const open = preflight.value;
  useEffect(() => {
    const dialog = sheet.current;
    if (open && dialog && !dialog.open) dialog.showModal();
    if (!open && dialog?.open) dialog.close();
  }, [open]);
  return (
    <dialog
      ref={sheet}
      class="preflight"
      aria-label="Before the start"
      onClose={() => {
        preflight.value = false;
      }}
    >
      {open && <Sheet />}
    </dialog>
  );
}

/** Why it can't start; "" when it can. `despite`: what is hopeless may be tried. */
function blocked(despite: boolean): string {
  if (broken.value) return "The text can't be read.";
  if (flying.value) return `The vehicle is ${PHASES[phase.value].toLowerCase()}.`;
  if (link.value.look !== "live") return "There is no live vehicle.";
  if (phase.value === MissionPhase.UNSPECIFIED) return "The vehicle has not told its state.";
  const id = live.latest("tlm/description")?.vehicleId;
  if (id && id !== mission.value.vehicle)
    return `The mission is for ${mission.value.vehicle}, the vehicle here is ${id}.`;
  if (plan.line.link.value === "open" && !told.value)
    return "The forecast of this very text is not there yet.";
  if ((plan.forecast.value?.problems.length ?? 0) > 0) return "The mission breaks a rule: see Findings.";
  if (hard.value.length > 0 && !despite) return "It can't work as it is: see Findings.";
  if (badge.value === "elsewhere") return "The stored file was changed by somebody else: save first.";
  return seedRefused.value ? "The seed is no whole number." : "";
}

function Sheet() {
  const asked = useSignal(false);
  const despite = useSignal(false);
  const starting = useSignal(false);
  const hopeless = hard.value.length > 0;
  const why = blocked(despite.value);
  const asks = soft.value.length > 0 && !asked.value;
  const start = async (): Promise<void> => {
    starting.value = true;
    const shown = text.peek();
    const ready = !unsaved.peek() || (await save());
    const file = { name: name.peek(), sha256: hash.peek() };
    if (ready && text.peek() === shown && (await startShown(file, hopeless))) {
      preflight.value = false;
      go("live");
    }
    starting.value = false;
  };
  return (
    <>
      <header class="panel-head">
        <h2>Before the start</h2>
        <span class="grow" />
        <button type="button" class="quiet" aria-label="Close" onClick={() => (preflight.value = false)}>
          <CrossIcon />
        </button>
      </header>
      <div class="preflight-body">
        <dl class="preflight-facts">
          <MissionRows />
          <VehicleRows />
          <Chances />
          <Row name="Abort" look="info">
            Hold <b>Hold to abort</b> in the top line: the mission ends at once and all actuators come to
            rest; the vehicle drifts and rises or sinks by its own buoyancy.
          </Row>
          <Row name="What happens when" look="info">
            <Failsafes />
          </Row>
        </dl>
        <Ask
          look="warning"
          words={`I have read ${soft.value.length === 1 ? "the warning" : `the ${soft.value.length} warnings`}`}
          findings={soft.value}
          ticked={asked}
        />
        <Ask
          look="alarm"
          words="Start all the same, though it can't work"
          findings={hard.value}
          ticked={despite}
        />
        {notice.value && <RefusalNotice title={notice.value.title} refusal={notice.value.refusal} />}
        {trouble.value && <RefusalNotice title="Not saved." refusal={trouble.value} />}
      </div>
      <footer class="preflight-foot">
        <span class={why ? "lost" : "muted"}>{why || (unsaved.value ? "It is saved first." : "")}</span>
        <HoldButton
          name="Start the mission"
          class="start"
          holdMs={800}
          why={
            why ||
            (asks
              ? "Something above is to be confirmed first"
              : starting.value || saving.value
                ? "It is being saved or started"
                : "")
          }
          onHeld={() => void start()}
        >
          <PlayIcon />{" "}
          {starting.value ? "Starting" : unsaved.value ? "Hold to save and start" : "Hold to start"}
          {hopeless && despite.value && !starting.value && " all the same"}
        </HoldButton>
      </footer>
    </>
  );
}

/** Farther apart, times of the run and of the console can't be compared. */
const CLOCK_S = 0.5;
type Look = "good" | "warning" | "alarm" | "info";
const ICONS = { good: CheckIcon, warning: WarningIcon, alarm: AlarmIcon };

function Row({ name: word, look, children }: { name: string; look: Look; children: ComponentChildren }) {
  const Icon = look === "info" ? undefined : ICONS[look];
  return (
    <div data-look={look}>
      <dt>
        {Icon && <Icon />} {word}
      </dt>
      <dd>{children}</dd>
    </div>
  );
}

/** What the mission says beyond way and dock: each thing differs from the vehicle's own. */
function differences(): string[] {
  const raw = table(mission.value.raw);
  const found: string[] = [];
  for (const [section, values] of Object.entries(table(raw.parameters)))
    for (const [field, value] of Object.entries(table(values)))
      found.push(`${section}.${field} = ${Array.isArray(value) ? `[${value.join(", ")}]` : String(value)}`);
  for (const key of ["sensors", "trim", "end"]) if (raw[key] !== undefined) found.push(`${key} set`);
  const faults = mission.value.events.fault;
  if (faults.length > 0) found.push(`${faults.length} fault${faults.length > 1 ? "s" : ""} of actuators`);
  return found;
}

function MissionRows() {
  const view = mission.value;
  const other = differences();
  return (
    <>
      <Row name="Mission" look={unsaved.value ? "warning" : "good"}>
        <b>{view.title || name.value}</b> <span class="code muted">{name.value}</span>
        <br />
        <span class="muted">hash </span>
        <span class="code" title={hash.value}>
          {hash.value.slice(0, 12)}
        </span>
        <span class="muted">
          , at most {clock(view.duration)}, seed {seed.value.trim() || view.seed}
        </span>
      </Row>
      <Row name="Differs from defaults" look={other.length > 0 ? "warning" : "good"}>
        {other.length === 0 ? "nothing" : other.slice(0, 8).join("; ")}
        {other.length > 8 && ` and ${other.length - 8} more`}
      </Row>
    </>
  );
}

function VehicleRows() {
  const description = live.latest("tlm/description");
  const match = description?.vehicleId === mission.value.vehicle;
  const status = live.latest("server/status");
  return (
    <>
      <Row name="Vehicle" look={match ? "good" : "alarm"}>
        {description ? `${description.vehicleName} (${description.vehicleId})` : "none has spoken"}
        {vehicle.value && description && vehicle.value.sha256 !== description.sha256 && (
          <span class="muted">; its file is another build than the forecast's</span>
        )}
      </Row>
      <Row name="Link" look={link.value.look === "live" ? "good" : "alarm"}>
        {link.value.label}
        {status?.recorderTrouble
          ? `; this run would not be recorded: ${status.recorderTrouble}`
          : "; the run is recorded"}
      </Row>
      <Row name="Clock" look={Math.abs(status?.clockOffsetS ?? 0) < CLOCK_S ? "good" : "warning"}>
        the vehicle's is <span class="num">{signed((status?.clockOffsetS ?? 0) * 1000, 0)} ms</span> off the
        server's
      </Row>
      <Row name="Command" look="info">
        Whoever has this console open can pause and abort ({status?.streamClients ?? 1} open now).{" "}
        {status?.busNotice}
      </Row>
    </>
  );
}

function Chances() {
  const forecast = plan.forecast.value;
  const chance = plan.current.value ? forecast?.chance : undefined;
  if (!chance)
    return (
      <Row name="Forecast" look="warning">
        none for this text
      </Row>
    );
  const share = chance.docked / Math.max(1, chance.of);
  return (
    <Row name="Forecast" look={share >= 0.95 ? "good" : "warning"}>
      docks in <b class="num">{chance.docked}</b> of <span class="num">{chance.of}</span> (
      {percent(chance.low)}–{percent(chance.high)} %){othersIn(chance) && `; ${othersIn(chance)}`}
    </Row>
  );
}
