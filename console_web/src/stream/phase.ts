// What a mission's phase means for the vehicle: whether it is flown, whether an actuator may move, which
// mode's gains count.
import { MissionPhase, Mode, type Supervisor } from "../gen/bumpless_pb";

export const PHASES: Record<MissionPhase, string> = {
  [MissionPhase.UNSPECIFIED]: "Unknown",
  [MissionPhase.IDLE]: "Idle",
  [MissionPhase.RUNNING]: "Running",
  [MissionPhase.PAUSED]: "Holding",
  [MissionPhase.COMPLETED]: "Over",
  [MissionPhase.ABORTED]: "Aborted",
};

/** A mission is being flown: it runs, or waits in a pause. */
export function isFlying(phase: MissionPhase | undefined): boolean {
  return phase === MissionPhase.RUNNING || phase === MissionPhase.PAUSED;
}

/** Control is in force: after its mission a vehicle holds station; aborted or idle it does nothing. */
export function isInForce(phase: MissionPhase | undefined): boolean {
  return isFlying(phase) || phase === MissionPhase.COMPLETED;
}

/** Whose gains and weights count. A vehicle that does not say holds station in H while paused. */
export function flownMode(supervisor: Supervisor | undefined, phase: MissionPhase | undefined): Mode {
  if (!supervisor || !isInForce(phase)) return Mode.UNSPECIFIED;
  if (supervisor.flown) return supervisor.flown;
  return phase === MissionPhase.PAUSED ? Mode.HOVER : supervisor.mode;
}
