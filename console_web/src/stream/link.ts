// The one sentence that says whether what is shown is live, and what the mission does.
import { computed } from "@preact/signals";
import { LinkState, MissionPhase } from "../gen/bumpless_pb";
import { live } from "./store";

export type LinkLook = "live" | "stale" | "lost" | "waiting" | "offline";

export interface Link {
  look: LinkLook;
  label: string;
}

const LINKS = {
  serverLost: { look: "offline", label: "Server lost" },
  connecting: { look: "waiting", label: "Connecting" },
  serverSilent: { look: "offline", label: "Server silent" },
  live: { look: "live", label: "Live" },
  late: { look: "stale", label: "Telemetry late" },
  lost: { look: "lost", label: "Link lost" },
  none: { look: "waiting", label: "No vehicle yet" },
} satisfies Record<string, Link>;

export const link = computed((): Link => {
  const connection = live.connection.value;
  if (connection === "lost") return LINKS.serverLost;
  const status = live.latest("server/status");
  if (connection === "connecting" || !status) return LINKS.connecting;
  if (!live.isFresh("server/status")) return LINKS.serverSilent;
  switch (status.link) {
    case LinkState.LIVE:
      return live.isFresh("tlm/navigation") ? LINKS.live : LINKS.late;
    case LinkState.STALE:
      return LINKS.late;
    case LinkState.LOST:
      return LINKS.lost;
    default:
      return LINKS.none;
  }
});

export const PHASES: Record<MissionPhase, string> = {
  [MissionPhase.UNSPECIFIED]: "Unknown",
  [MissionPhase.IDLE]: "Idle",
  [MissionPhase.RUNNING]: "Running",
  [MissionPhase.PAUSED]: "Paused",
  [MissionPhase.COMPLETED]: "Over",
  [MissionPhase.ABORTED]: "Aborted",
};

export const phase = computed(
  (): MissionPhase => live.latest("tlm/mission")?.phase ?? MissionPhase.UNSPECIFIED,
);

export function isFlying(in_: MissionPhase | undefined): boolean {
  return in_ === MissionPhase.RUNNING || in_ === MissionPhase.PAUSED;
}

export const flying = computed(() => isFlying(phase.value));
