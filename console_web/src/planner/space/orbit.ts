// A camera that goes round a place of the water, and where things are on its picture.
import type { Size } from "../map/viewport";
import type { Ned } from "../model/geometry";

export interface Orbit {
  /** The place it looks at. */
  at: Ned;
  /** Heading it looks along, and how far down, rad. */
  azimuth: number;
  elevation: number;
  distance: number;
  /** Depths are drawn so many times larger. */
  stretch: number;
}

/** Place on the picture, px, and distance along the line of sight, m. */
export type Seen = readonly [x: number, y: number, far: number];

const VIEW_ANGLE = (40 * Math.PI) / 180;
const NEAR_M = 0.05;
const LEVEL = 0.03; // never quite level, never quite from above: north stays up
const STEEPEST = Math.PI / 2 - 0.01;

/** A camera with all that its picture needs worked out once. */
export class Lens {
  readonly scale: number; // px at 1 m
  private readonly right: readonly [number, number];
  private readonly up: readonly [number, number, number];
  private readonly forward: readonly [number, number, number];

  constructor(
    readonly orbit: Orbit,
    readonly size: Size,
  ) {
    this.scale = size.height / 2 / Math.tan(VIEW_ANGLE / 2);
    const [ca, sa] = [Math.cos(orbit.azimuth), Math.sin(orbit.azimuth)];
    const [ce, se] = [Math.cos(orbit.elevation), Math.sin(orbit.elevation)];
    this.right = [-sa, ca]; // north, east
    this.up = [ca * se, sa * se, ce]; // north, east, up
    this.forward = [ca * ce, sa * ce, -se];
  }

  /** North, east and up from the camera's place, in its own axes. */
  private own([n, e, d]: Ned): Seen {
    const { at, stretch, distance } = this.orbit;
    const [dn, de, du] = [n - at[0], e - at[1], (at[2] - d) * stretch];
    const [f, u] = [this.forward, this.up];
    return [
      this.right[0] * dn + this.right[1] * de,
      u[0] * dn + u[1] * de + u[2] * du,
      f[0] * dn + f[1] * de + f[2] * du + distance,
    ];
  }

  private onPicture([a, b, far]: Seen): Seen {
    const k = this.scale / far;
    return [this.size.width / 2 + k * a, this.size.height / 2 - k * b, far];
  }

  /** Undefined: behind the camera. */
  see(place: Ned): Seen | undefined {
    const own = this.own(place);
    return own[2] < NEAR_M ? undefined : this.onPicture(own);
  }

  /** A line, cut where it goes behind the camera. */
  seeLine(from: Ned, to: Ned): readonly [Seen, Seen] | undefined {
    let [a, b] = [this.own(from), this.own(to)];
    if (a[2] < NEAR_M && b[2] < NEAR_M) return undefined;
    if (a[2] < NEAR_M) a = cut(a, b);
    else if (b[2] < NEAR_M) b = cut(b, a);
    return [this.onPicture(a), this.onPicture(b)];
  }

  /** The place at a depth that is seen at a pixel; undefined: the line of sight does not meet it. */
  placeAt(px: number, py: number, depth: number): Ned | undefined {
    const [a, b] = [(px - this.size.width / 2) / this.scale, (this.size.height / 2 - py) / this.scale];
    const { at, stretch, distance } = this.orbit;
    const [f, u, r] = [this.forward, this.up, this.right];
    const way = [f[0] + a * r[0] + b * u[0], f[1] + a * r[1] + b * u[1], f[2] + b * u[2]] as const;
    const height = (at[2] - depth) * stretch + distance * f[2];
    const far = height / way[2];
    if (!(far > NEAR_M) || far > 1e5) return undefined;
    return [at[0] - distance * f[0] + far * way[0], at[1] - distance * f[1] + far * way[1], depth];
  }

  /** Metres of depth that a pixel is, at a distance along the line of sight. */
  depthPerPx(far: number): number {
    return far / this.scale / this.orbit.stretch / Math.max(0.2, Math.cos(this.orbit.elevation));
  }
}

function cut(behind: Seen, ahead: Seen): Seen {
  const share = (NEAR_M - behind[2]) / (ahead[2] - behind[2]);
  const at = (i: 0 | 1): number => behind[i] + share * (ahead[i] - behind[i]);
  return [at(0), at(1), NEAR_M];
}

export function turned(orbit: Orbit, dx: number, dy: number): Orbit {
  const elevation = Math.min(STEEPEST, Math.max(LEVEL, orbit.elevation + dy));
  return { ...orbit, azimuth: orbit.azimuth + dx, elevation };
}

export function nearer(orbit: Orbit, by: number): Orbit {
  return { ...orbit, distance: Math.min(2e4, Math.max(0.5, orbit.distance / by)) };
}

/** Moved so that what is seen goes along with the pointer. */
export function slid(orbit: Orbit, size: Size, dx: number, dy: number): Orbit {
  const metres = (orbit.distance * 2 * Math.tan(VIEW_ANGLE / 2)) / Math.max(1, size.height);
  const [c, s] = [Math.cos(orbit.azimuth), Math.sin(orbit.azimuth)];
  const [right, ahead] = [-dx * metres, (dy * metres) / Math.max(0.3, Math.sin(orbit.elevation))];
  return {
    ...orbit,
    at: [orbit.at[0] + ahead * c - right * s, orbit.at[1] + ahead * s + right * c, orbit.at[2]],
  };
}

const MARGIN_PX = 36;
const LEAST_M = 6;

/** As it was turned, and so far that all places are in view. */
export function around(orbit: Orbit, size: Size, places: readonly Ned[]): Orbit {
  const spans = ([0, 1, 2] as const).map((axis) => {
    const all = places.map((place) => place[axis]);
    return [Math.min(...all), Math.max(...all)] as const;
  });
  const [n, e, d] = spans.map(([low, high]) => (low + high) / 2) as [number, number, number];
  let seen: Orbit = { ...orbit, at: [n, e, d], distance: LEAST_M };
  const outside = ([x, y]: Seen): boolean =>
    x < MARGIN_PX || y < MARGIN_PX || x > size.width - MARGIN_PX || y > size.height - MARGIN_PX;
  for (let i = 0; i < 60; i++) {
    const lens = new Lens(seen, size);
    if (!places.some((place) => outside(lens.see(place) ?? [-1, -1, 0]))) break;
    seen = { ...seen, distance: seen.distance * 1.15 };
  }
  return seen;
}
