// What the plots show: one row per received control cycle. Columns have their full length from the start,
// so that a page that stays open for a watch does not grow.
import { Mode } from "../gen/bumpless_pb";
import { WRENCH_AXES, wrenchOf } from "../lib/wrench";
import { isFlying } from "./link";
import { type LiveStore, live } from "./store";

/** Ten minutes at 20 Hz, and room before old rows are dropped. */
const CAPACITY = 12_000;
const ROOM = 15_000;
/** A pause longer than this breaks the lines, s. */
const GAP = 0.5;

type Row = Record<string, number | null | undefined>;

export class History {
  /** Rows in use of every column. */
  length = 0;
  /** Vehicle time, s since the UNIX epoch. */
  readonly time = new Float64Array(ROOM);
  readonly mode = new Uint8Array(ROOM);
  /** Vehicle time at mission time 0, s; NaN when no mission has been seen. */
  missionStart = Number.NaN;
  private readonly columns = new Map<string, Float64Array>();
  private flying = false;
  private unwrapped: Record<string, number> = {};

  constructor(private readonly store: LiveStore) {
    store.onReceive((changed, past) => {
      if (changed.has("tlm/navigation")) this.append(past);
    });
  }

  first(): number {
    return this.length ? (this.time[0] as number) : Number.NaN;
  }

  last(): number {
    return this.length ? (this.time[this.length - 1] as number) : Number.NaN;
  }

  /** A column's rows, NaN where there is no value; undefined for a name that never came. */
  column(name: string): Float64Array | undefined {
    return this.columns.get(name);
  }

  /** Index of the first row at or after `time`, s. */
  firstIndex(time: number): number {
    let low = 0;
    let high = this.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((this.time[middle] as number) < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** The past that a new connection begins with fills what was missed, and leaves alone what is here. */
  private append(past: boolean): void {
    const nav = this.store.received("tlm/navigation");
    if (!nav?.stamp) return;
    const time = Number(nav.stamp.timeNs) / 1e9;
    const previous = this.last();
    if (time === previous || (past && time < previous)) return;
    if (time < previous) this.clear();
    // A simulated vehicle is put at the start of its mission: that jump is no motion.
    const supervisor = this.store.received("tlm/supervisor");
    const flying = isFlying(supervisor?.phase || this.store.received("tlm/mission")?.phase);
    if (time - previous > GAP || (flying && !this.flying)) this.push(previous + 0.01, Mode.UNSPECIFIED, {});
    if (flying) this.missionStart = time - nav.stamp.missionTimeS;
    this.flying = flying;
    this.push(time, (flying && supervisor?.mode) || Mode.UNSPECIFIED, this.row(flying));
  }

  private row(flying: boolean): Row {
    const nav = this.store.received("tlm/navigation");
    const guidance = this.store.received("tlm/guidance");
    const supervisor = this.store.received("tlm/supervisor");
    const control = this.store.received("tlm/control");
    const allocation = this.store.received("tlm/allocation");
    const yaw = this.unwrap("yaw", nav?.attitude?.yawDeg);
    const yawReference = guidance?.attitudeReference?.yawDeg;
    const row: Row = {
      depth: nav?.depthM,
      depth_reference: guidance?.depthReferenceM,
      speed: nav?.velocityBodyMps?.x,
      speed_reference: guidance?.surgeSpeedReferenceMps,
      yaw,
      yaw_reference: yaw == null || yawReference == null ? null : yaw + wrapDegrees(yawReference - yaw),
      pitch: nav?.attitude?.pitchDeg,
      pitch_reference: guidance?.attitudeReference?.pitchDeg,
      roll: nav?.attitude?.rollDeg,
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
    for (const actuator of this.store.received("tlm/actuators")?.actuators ?? []) {
      row[`command_${actuator.name}`] = actuator.command;
      row[`feedback_${actuator.name}`] = actuator.feedback;
    }
    return row;
  }

  private push(time: number, mode: Mode, row: Row): void {
    if (Number.isNaN(time)) return; // nothing stands before the first row
    if (this.length === ROOM) this.drop(ROOM - CAPACITY);
    const at = this.length++;
    this.time[at] = time;
    this.mode[at] = mode;
    for (const name of Object.keys(row)) {
      if (!this.columns.has(name)) this.columns.set(name, new Float64Array(ROOM).fill(Number.NaN));
    }
    for (const [name, column] of this.columns) {
      const value = row[name];
      column[at] = value != null && Number.isFinite(value) ? value : Number.NaN;
    }
  }

  private drop(count: number): void {
    this.length -= count;
    for (const column of [this.time, this.mode, ...this.columns.values()]) column.copyWithin(0, count);
  }

  private clear(): void {
    this.length = 0;
    this.columns.clear();
    this.unwrapped = {};
    this.missionStart = Number.NaN;
  }

  /** Angles go on past 360 so that a line never jumps. */
  private unwrap(name: string, degrees: number | undefined): number | null {
    if (degrees === undefined || !Number.isFinite(degrees)) return null;
    const before = this.unwrapped[name] ?? degrees;
    const whole = before + wrapDegrees(degrees - before);
    this.unwrapped[name] = whole;
    return whole;
  }
}

/** To (-180, 180]. */
export function wrapDegrees(degrees: number): number {
  const wrapped = ((degrees % 360) + 360) % 360;
  return wrapped > 180 ? wrapped - 360 : wrapped;
}

/** The page's one history of the stream. */
export const history = new History(live);
