// What the docking automaton is about: stage, approach, and why the last one was given up.
import { DockingStage, type Supervisor, WaveOffReason } from "../gen/bumpless_pb";
import { age, headingOf } from "../lib/format";
import { inForce } from "../stream/screen";

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
const FRESH_FIX_S = 2;

/** "TARGET_LOST" as people say it. */
function words(reason: WaveOffReason): string {
  return (WaveOffReason[reason] ?? `reason ${reason}`).replaceAll("_", " ").toLowerCase();
}

export function DockingLine({ supervisor: s }: { supervisor: Supervisor }) {
  if (s.dockingStage === DockingStage.UNSPECIFIED || !inForce.value) return null;
  const approach = s.dockingTries > 0 && `approach ${s.dockingTries} of ${s.dockingTriesMost}`;
  return (
    <p class="docking-line" role="group" aria-label="Docking">
      <b>{STAGES[s.dockingStage] ?? "Docking"}</b>
      {approach && <span class="num">{approach}</span>}
      <span class="muted num">heading {headingOf(s.approachHeadingDeg, 0)}°</span>
      {s.fixAgeS > FRESH_FIX_S && <span class="muted num">target last seen {age(s.fixAgeS)} ago</span>}
      {s.waveOffReason !== WaveOffReason.UNSPECIFIED && (
        <span class="wave-off">waved off: {words(s.waveOffReason)}</span>
      )}
    </p>
  );
}
