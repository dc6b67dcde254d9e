// What the docking automaton is about: stage, approach, and why the last one was given up.
import { useEffect } from "preact/hooks";
import { DockingStage, type Supervisor, WaveOffReason } from "../gen/bumpless_pb";
import { age, headingOf } from "../lib/format";
import { headingsOf, heldWord } from "../lib/held";
import { wrapDegrees } from "../stream/history";
import { inForce, screen } from "../stream/screen";
import { CheckIcon, CrossIcon, WarningIcon } from "../ui/icons";
import { heldNow, watchStation } from "./station";

const STAGES: Record<DockingStage, string> = {
  [DockingStage.UNSPECIFIED]: "",
  [DockingStage.TRANSIT]: "In transit",
  [DockingStage.ENTRY]: "Flying round to the approach line",
  [DockingStage.APPROACH]: "On the approach line",
  [DockingStage.BACK]: "Backing off",
  [DockingStage.HOLD]: "Holding clear of the dock",
  [DockingStage.CREEP]: "Creeping into the dock",
  [DockingStage.CAPTURED]: "Latched in the dock",
};
/** Where the last approach has been given up; in any other the vehicle tries again. */
const LEFT = new Set([DockingStage.BACK, DockingStage.HOLD]);
const FRESH_FIX_S = 2;

/** "TARGET_LOST" as people say it. */
function words(reason: WaveOffReason): string {
  return (WaveOffReason[reason] ?? `reason ${reason}`).replaceAll("_", " ").toLowerCase();
}

/** The age of a fix that never was counts from the start. */
function lastSeen({ fixAgeS, stamp }: Supervisor): string {
  const never = stamp !== undefined && fixAgeS >= stamp.missionTimeS - 0.5;
  return never ? "target not seen yet" : `target last seen ${age(fixAgeS)} ago`;
}

export function DockingLine({ supervisor: s }: { supervisor: Supervisor }) {
  if (s.dockingStage === DockingStage.UNSPECIFIED || !inForce.value) return null;
  const approach = s.dockingTries > 0 && `approach ${s.dockingTries} of ${s.dockingTriesMost}`;
  return (
    <p class="docking-line" role="group" aria-label="Docking">
      <b>{STAGES[s.dockingStage] ?? "Docking"}</b>
      {approach && <span class="num">{approach}</span>}
      <span class="muted num">heading {headingOf(s.approachHeadingDeg, 0).padStart(3, "0")}°</span>
      {screen.isLive && <Holds told={s.approachHeadingDeg} />}
      {s.fixAgeS > FRESH_FIX_S && <span class="muted num">{lastSeen(s)}</span>}
      {s.waveOffReason !== WaveOffReason.UNSPECIFIED && (
        <span class="wave-off">
          waved off{LEFT.has(s.dockingStage) ? "" : " before"}: {words(s.waveOffReason)}
        </span>
      )}
    </p>
  );
}

const LOOKS = {
  accepted: { Icon: CheckIcon, look: "good" },
  warned: { Icon: WarningIcon, look: "warning" },
  refused: { Icon: CrossIcon, look: "lost" },
} as const;

/** From here on it is another heading, deg. */
const TURNS_DEG = 2;

/** Whether its heading holds station in the current that it estimates, and which would. `told`: the heading in use. */
function Holds({ told }: { told: number }) {
  useEffect(watchStation, []);
  const held = heldNow.value;
  if (!held) return null;
  const { Icon, look } = LOOKS[held.zone];
  const good = headingsOf(held, "accepted") || "no heading surely";
  const turns = Math.abs(wrapDegrees(held.heading_deg - told)) >= TURNS_DEG;
  return (
    <span class={`holds ${look}`} role="group" aria-label="Station keeping" title={held.reason || undefined}>
      <Icon size={11} /> {turns && `will turn to ${headingOf(held.heading_deg, 0).padStart(3, "0")}°, which `}
      {heldWord(held.zone)}
      <span class="muted num">{held.zone === "accepted" ? good : `would hold: ${good}`}</span>
    </span>
  );
}
