// What the plots show: one row per received control cycle, in plain columns.
import { MissionPhase, Mode } from "../gen/bumpless_pb";
import type { LiveStore } from "./store";

export type Column = (number | null)[];

/** Ten minutes at 20 Hz. */
const CAPACITY = 12_000;
/** A pause longer than this breaks the lines, s. */
const GAP = 0.5;
export const WRENCH_AXES = ["X", "Y", "Z", "K", "M", "N"] as const;
export type WrenchAxis = (typeof WRENCH_AXES)[number];

export class History {
  /** Vehicle time, s since the UNIX epoch. */
  time: number[] = [];
  mode: Mode[] = [];
  columns: Record<string, Column> = {};
  /** Vehicle time at mission time 0, s; NaN when no mission has been seen. */
  missionStart = NaN;
  private flying = false;
  private unwrapped: Record<string, number> = {};

  constructor(store: LiveStore) {
    store.onChange((changed, past) => {
      if (changed.has("tlm/navigation")) this.append(store, past);
    });
  }

  last(): number {
    return this.time.at(-1) ?? NaN;
  }

  /** The past that a new connection begins with fills what was missed, and leaves alone what is here. */
  private append(store: LiveStore, past: boolean): void {
    const nav = store.latest("tlm/navigation");
    if (!nav?.stamp) return;
    const time = Number(nav.stamp.timeNs) / 1e9;
    const previous = this.last();
    if (time === previous || (past && time < previous)) return;
    if (time < previous) this.clear();
    // A simulated vehicle is put at the start of its mission: that jump is no motion.
    const phase = store.latest("tlm/supervisor")?.phase || store.latest("tlm/mission")?.phase;
    const flying = phase === MissionPhase.RUNNING || phase === MissionPhase.PAUSED;
    if (time - previous > GAP || (flying && !this.flying)) this.push(previous + 0.01, Mode.UNSPECIFIED, {});
    if (flying) this.missionStart = time - nav.stamp.missionTimeS;
    this.flying = flying;

    const guidance = store.latest("tlm/guidance");
    const supervisor = store.latest("tlm/supervisor");
    const control = store.latest("tlm/control");
    const allocation = store.latest("tlm/allocation");
    const yaw = this.unwrap("yaw", nav.attitude?.yawDeg);
    const yawReference = guidance?.attitudeReference?.yawDeg;
    const row: Record<string, number | null | undefined> = {
      depth: nav.depthM,
      depth_reference: guidance?.depthReferenceM,
      speed: nav.velocityBodyMps?.x,
      speed_reference: guidance?.surgeSpeedReferenceMps,
      yaw,
      yaw_reference:
        yaw == null || yawReference == null ? null : yaw + wrapDegrees(yawReference - yaw),
      pitch: nav.attitude?.pitchDeg,
      pitch_reference: guidance?.attitudeReference?.pitchDeg,
      roll: nav.attitude?.rollDeg,
      range: supervisor?.rangeM,
      kappa: flying ? supervisor?.kappa : null,
      detection: supervisor && Number(supervisor.detection),
      detection_raw: supervisor && Number(supervisor.detectionRaw),
      solve_time: allocation?.solveTimeUs,
      residual: allocation?.residualNorm,
    };
    for (const axis of WRENCH_AXES) {
      row[`demanded_${axis}`] = wrenchOf(control?.demanded, axis);
      row[`achieved_${axis}`] = wrenchOf(control?.achieved, axis);
    }
    store.latest("tlm/actuators")?.actuators.forEach((actuator) => {
      row[`command_${actuator.name}`] = actuator.command;
      row[`feedback_${actuator.name}`] = actuator.feedback;
    });
    this.push(time, (flying && supervisor?.mode) || Mode.UNSPECIFIED, row);
  }

  private push(time: number, mode: Mode, row: Record<string, number | null | undefined>): void {
    const length = this.time.length;
    this.time.push(time);
    this.mode.push(mode);
    for (const name of Object.keys(row)) this.columns[name] ??= new Array<null>(length).fill(null);
    for (const [name, column] of Object.entries(this.columns)) {
      const value = row[name];
      column.push(value != null && Number.isFinite(value) ? value : null);
    }
    if (this.time.length > CAPACITY * 1.25) this.drop(this.time.length - CAPACITY);
  }

  private drop(count: number): void {
    this.time.splice(0, count);
    this.mode.splice(0, count);
    for (const column of Object.values(this.columns)) column.splice(0, count);
  }

  private clear(): void {
    this.time = [];
    this.mode = [];
    this.columns = {};
    this.unwrapped = {};
    this.missionStart = NaN;
  }

  /** Angles go on past 360 so that a line never jumps. */
  private unwrap(name: string, degrees: number | undefined): number | null {
    if (degrees === undefined || !Number.isFinite(degrees)) return null;
    const before = this.unwrapped[name] ?? degrees;
    return (this.unwrapped[name] = before + wrapDegrees(degrees - before));
  }
}

/** To (-180, 180]. */
export function wrapDegrees(degrees: number): number {
  const wrapped = ((degrees % 360) + 360) % 360;
  return wrapped > 180 ? wrapped - 360 : wrapped;
}

type WrenchMessage = { xN: number; yN: number; zN: number; kNm: number; mNm: number; nNm: number };

export function wrenchOf(wrench: WrenchMessage | undefined, axis: WrenchAxis): number | null {
  if (!wrench) return null;
  switch (axis) {
    case "X": return wrench.xN;
    case "Y": return wrench.yN;
    case "Z": return wrench.zN;
    case "K": return wrench.kNm;
    case "M": return wrench.mNm;
    case "N": return wrench.nNm;
  }
}
