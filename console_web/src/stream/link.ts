// The one sentence that says whether what is shown is live, and what the mission does.
import { computed } from "@preact/signals";
import { LinkState, MissionPhase } from "../gen/bumpless_pb";
import { isFlying, isInForce } from "./phase";
import { live } from "./store";

export { PHASES } from "./phase";

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
  if (live.silent) return LINKS.serverSilent;
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

export const phase = computed(
  (): MissionPhase => live.latest("tlm/mission")?.phase ?? MissionPhase.UNSPECIFIED,
);

/** A mission is being flown, as far as is known. */
export const flying = computed(() => isFlying(phase.value));

/** Share of its travel from which an actuator counts as moving. */
const AT_REST = 0.02;

/** An actuator may move: control is in force, or one is seen to move. What is not known may be. */
export const moving = computed((): boolean => {
  if (phase.value === MissionPhase.UNSPECIFIED) return link.value.look !== "waiting";
  if (isInForce(phase.value)) return true;
  return (live.latest("tlm/actuators")?.actuators ?? []).some(
    ({ feedback, amplitudeLower, amplitudeUpper, unit }) =>
      unit === "rpm" && Math.abs(feedback) > AT_REST * (amplitudeUpper - amplitudeLower),
  );
});
