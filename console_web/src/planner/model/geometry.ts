// Plane geometry of plans. Positions are NED in metres; headings in degrees from north over east.

export type Ned = readonly [north: number, east: number, down: number];
const RAD = Math.PI / 180;

export function wrapped(degrees: number): number {
  return ((degrees % 360) + 360) % 360;
}

/** Difference of headings from -180 up to 180. */
export function turn(from: number, to: number): number {
  return wrapped(to - from + 180) - 180;
}

export function bearing(from: Ned, to: Ned): number {
  return wrapped(Math.atan2(to[1] - from[1], to[0] - from[0]) / RAD);
}

export function distance(a: Ned, b: Ned): number {
  return Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

export function flat(a: Ned, b: Ned): number {
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

/** From `at`, `metres` along `heading`, at the same depth. */
export function along(at: Ned, heading: number, metres: number): Ned {
  return [at[0] + metres * Math.cos(heading * RAD), at[1] + metres * Math.sin(heading * RAD), at[2]];
}

/** Where the legs should end: `standoff` before the target on its heading. */
export function observationPoint(target: Ned, heading: number, standoff: number): Ned {
  return along(target, heading, -standoff);
}

export function rotated(point: Ned, about: Ned, degrees: number): Ned {
  const [n, e] = [point[0] - about[0], point[1] - about[1]];
  const [c, s] = [Math.cos(degrees * RAD), Math.sin(degrees * RAD)];
  return [about[0] + c * n - s * e, about[1] + s * n + c * e, point[2]];
}

export function shifted(point: Ned, by: Ned): Ned {
  return [point[0] + by[0], point[1] + by[1], point[2] + by[2]];
}

/** To the nearest multiple of `grid`; as it is when there is no grid. */
export function snapped(value: number, grid: number): number {
  return grid > 0 ? Math.round(value / grid) * grid : value;
}

export interface LegFacts {
  /** Metres in space, and of the way up to its end. */
  length: number;
  end: number;
  /** Seconds at the leg's speed; undefined without a speed. */
  seconds: number | undefined;
  /** Metres down per second. */
  depthRate: number | undefined;
  heading: number;
}

/** Length, time and depth rate of each leg of a way. */
export function legFacts(start: Ned, legs: readonly { at: Ned; speed: number }[]): LegFacts[] {
  let from = start;
  let end = 0;
  return legs.map(({ at, speed }) => {
    const length = distance(from, at);
    end += length;
    const seconds = speed > 0 ? length / speed : undefined;
    const facts = {
      length,
      end,
      seconds,
      depthRate: seconds ? (at[2] - from[2]) / seconds : undefined,
      heading: bearing(from, at),
    };
    from = at;
    return facts;
  });
}

/** Distance flown over ground up to each sample, m. */
export function flown(north: readonly number[], east: readonly number[]): number[] {
  let sum = 0;
  return north.map((n, i) => {
    if (i > 0) sum += Math.hypot(n - (north[i - 1] ?? n), (east[i] ?? 0) - (east[i - 1] ?? 0));
    return sum;
  });
}

/** A grid step of 1, 2 or 5 times a power of ten that is at least `least`. */
export function niceStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(least, 1e-9)));
  return [1, 2, 5, 10].map((k) => k * power).find((step) => step >= least * (1 - 1e-9)) ?? 10 * power;
}
