// The one sentence that says whether what is shown is live.
import { LinkState, MissionPhase } from "../gen/bumpless_pb";
import { live } from "../stream/store";

export type LinkLook = "live" | "stale" | "lost" | "waiting" | "offline";

export interface Link {
  look: LinkLook;
  label: string;
}

export function linkNow(): Link {
  if (live.connection === "lost") return { look: "offline", label: "Server lost" };
  const status = live.latest("server/status");
  if (live.connection === "connecting" || !status) return { look: "waiting", label: "Connecting" };
  if (!live.isFresh("server/status")) return { look: "offline", label: "Server silent" };
  switch (status.link) {
    case LinkState.LIVE:
      return live.isFresh("tlm/navigation")
        ? { look: "live", label: "Live" }
        : { look: "stale", label: "Telemetry late" };
    case LinkState.STALE:
      return { look: "stale", label: "Telemetry late" };
    case LinkState.LOST:
      return { look: "lost", label: "Link lost" };
    default:
      return { look: "waiting", label: "No vehicle yet" };
  }
}

export const PHASES: Record<MissionPhase, string> = {
  [MissionPhase.UNSPECIFIED]: "Unknown",
  [MissionPhase.IDLE]: "Idle",
  [MissionPhase.RUNNING]: "Running",
  [MissionPhase.PAUSED]: "Paused",
  [MissionPhase.COMPLETED]: "Completed",
  [MissionPhase.ABORTED]: "Aborted",
};

export function phaseNow(): MissionPhase {
  return live.latest("tlm/mission")?.phase ?? MissionPhase.UNSPECIFIED;
}

export function isFlying(phase: MissionPhase): boolean {
  return phase === MissionPhase.RUNNING || phase === MissionPhase.PAUSED;
}
