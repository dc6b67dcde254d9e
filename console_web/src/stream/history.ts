// What the plots show: one row per received control cycle. Columns have their full length from the start,
// so that a page that stays open for a watch does not grow.
import { Mode } from "../gen/bumpless_pb";
import { type CycleRow, cycleRow, type Row } from "./cycle_row";
import { type LiveStore, live } from "./store";

/** Ten minutes at 20 Hz, and room before old rows are dropped. */
const CAPACITY = 12_000;
const ROOM = 15_000;
/** A pause longer than this breaks the lines, s. */
export const GAP = 0.5;
/** How far apart stand what was told before and after a step of the vehicle's clock, s. */
const STEP = 1;
/** A vehicle that is left alone drifts slower than this, and is estimated better. */
const FASTEST_MPS = 2;
const JUMP_M = 0.5;

export class History {
  /** Rows in use of every column. */
  length = 0;
  /** Vehicle time, s since the UNIX epoch; it goes on where the vehicle's clock stepped back. */
  readonly time = new Float64Array(ROOM);
  readonly mode = new Uint8Array(ROOM);
  /** Vehicle time at mission time 0, s; NaN when no mission has been seen. */
  missionStart = Number.NaN;
  /** What the present ramp comes from: a mode, or the present one when only settings changed. */
  rampFrom: Mode = Mode.UNSPECIFIED;
  private readonly columns = new Map<string, Float64Array>();
  private flying = false;
  private unwrapped: Record<string, number> = {};
  private shift = 0;
  private told = Number.NaN;
  private before: CycleRow | undefined;

  constructor(store?: LiveStore) {
    store?.onReceive((changed, past) => {
      const cycle = changed.has("tlm/navigation") && cycleRow((name) => store.received(name));
      if (cycle) this.append(cycle, past);
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

  /** How much of the time before row `i` it speaks for, s: nothing of a gap. */
  stretch(i: number): number {
    const whole = i ? (this.time[i] as number) - (this.time[i - 1] as number) : 0;
    return whole > this.gap ? 0 : whole;
  }

  /** Rows further apart than this are no neighbours, s. */
  gap = GAP;

  /** What follows is no neighbour of what is here: lines end. */
  breakOff(): void {
    this.push(this.last() + 0.01, Mode.UNSPECIFIED, {});
  }

  /** The past that a new connection begins with fills what was missed, and leaves alone what is here. */
  append(cycle: CycleRow, past = false): void {
    const previous = this.last();
    if (cycle.time === this.told) return;
    if (!past && cycle.time < this.told) this.shift += previous + STEP - (cycle.time + this.shift);
    const time = cycle.time + this.shift;
    if (past && time < previous) return;
    this.told = cycle.time;
    // A simulated vehicle is put at the start of its mission: that jump is no motion.
    const begins = (cycle.inForce && !this.flying) || this.isPut(cycle, time - previous);
    if (time - previous > this.gap || begins) this.breakOff();
    if (cycle.inForce) this.missionStart = time - cycle.missionTime;
    const ramps = cycle.inForce && this.before !== undefined && cycle.kappa < this.before.kappa;
    if (ramps) this.rampFrom = this.before?.mode ?? Mode.UNSPECIFIED;
    if (begins) this.rampFrom = Mode.UNSPECIFIED;
    this.flying = cycle.inForce;
    this.before = cycle;
    this.push(time, cycle.mode, this.withoutJumps(cycle.row));
  }

  /** Its place is told before its phase: it was put there where mission time begins anew, or no control moves it. */
  private isPut(cycle: CycleRow, passed: number): boolean {
    const before = this.before;
    if (!before) return false;
    if (cycle.missionTime < before.missionTime) return true;
    const way = ["north", "east", "depth"].map((axis) => (cycle.row[axis] ?? 0) - (before.row[axis] ?? 0));
    return !before.inForce && Math.hypot(...way) > JUMP_M + FASTEST_MPS * passed;
  }

  /** Angles go on past 360 so that a line never jumps. */
  private withoutJumps(row: Row): Row {
    const yaw = this.unwrap("yaw", row.yaw);
    const reference = row.yaw_reference;
    const yaw_reference = yaw == null || reference == null ? null : yaw + wrapDegrees(reference - yaw);
    return { ...row, yaw, yaw_reference };
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

  clear(): void {
    this.length = 0;
    this.columns.clear();
    this.unwrapped = {};
    this.missionStart = Number.NaN;
    this.told = Number.NaN;
    this.shift = 0;
    this.before = undefined;
    this.flying = false;
  }

  private unwrap(name: string, degrees: number | null | undefined): number | null {
    if (degrees == null || !Number.isFinite(degrees)) return null;
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
