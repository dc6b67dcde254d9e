// One control cycle as a row of the plots: what was told, and nothing for what was not in force.
import type { Mode } from "../gen/bumpless_pb";
import { WRENCH_AXES, wrenchOf } from "../lib/wrench";
import { flownMode, isInForce } from "./phase";
import type { MessageOf, TopicName } from "./topics";

export type Received = <K extends TopicName>(name: K) => MessageOf<K> | undefined;
export type Row = Record<string, number | null | undefined>;

export interface CycleRow {
  /** Vehicle time, s since the UNIX epoch. */
  time: number;
  /** Mission time, s. */
  missionTime: number;
  /** Control is in force: what is demanded, seen and solved is of this cycle. */
  inForce: boolean;
  /** Whose gains and weights count; UNSPECIFIED when none. */
  mode: Mode;
  kappa: number;
  row: Row;
}

/** Of the newest messages; undefined before the first navigation. Yaw is as told, within 360. */
export function cycleRow(received: Received): CycleRow | undefined {
  const nav = received("tlm/navigation");
  if (!nav?.stamp) return undefined;
  const supervisor = received("tlm/supervisor");
  const phase = supervisor?.phase || received("tlm/mission")?.phase;
  const inForce = isInForce(phase);
  return {
    time: Number(nav.stamp.timeNs) / 1e9,
    missionTime: nav.stamp.missionTimeS,
    inForce,
    mode: flownMode(supervisor, phase),
    kappa: supervisor?.kappa ?? Number.NaN,
    row: { ...measured(received), ...(inForce ? controlled(received) : {}) },
  };
}

function measured(received: Received): Row {
  const nav = received("tlm/navigation");
  const row: Row = {
    depth: nav?.depthM,
    speed: nav?.velocityBodyMps?.x,
    yaw: nav?.attitude?.yawDeg,
    pitch: nav?.attitude?.pitchDeg,
    roll: nav?.attitude?.rollDeg,
    north: nav?.positionNedM?.x,
    east: nav?.positionNedM?.y,
  };
  for (const actuator of received("tlm/actuators")?.actuators ?? []) {
    row[`command_${actuator.name}`] = actuator.command;
    row[`feedback_${actuator.name}`] = actuator.feedback;
  }
  return row;
}

/** What a control that is not in force leaves behind in its messages is no reference of this cycle. */
function controlled(received: Received): Row {
  const guidance = received("tlm/guidance");
  const supervisor = received("tlm/supervisor");
  const control = received("tlm/control");
  const allocation = received("tlm/allocation");
  const row: Row = {
    depth_reference: guidance?.depthReferenceM,
    speed_reference: guidance?.surgeSpeedReferenceMps,
    yaw_reference: guidance?.attitudeReference?.yawDeg,
    pitch_reference: guidance?.attitudeReference?.pitchDeg,
    cross_track: guidance?.crossTrackErrorM,
    range: supervisor?.rangeM,
    kappa: supervisor?.kappa,
    detection: supervisor && Number(supervisor.detection),
    detection_raw: supervisor && Number(supervisor.detectionRaw),
    solve_time: allocation?.solveTimeUs,
    residual: allocation?.residualNorm,
  };
  for (const axis of WRENCH_AXES) {
    row[`demanded_${axis}`] = wrenchOf(control?.demanded, axis);
    row[`achieved_${axis}`] = wrenchOf(control?.achieved, axis);
  }
  return row;
}
