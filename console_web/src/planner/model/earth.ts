// Places of the local frame on the earth and back, as the mission's `origin` has it: the same chart as the
// server's (bumpless.config.mission.origin), which a test compares with what is shown here.
import { table } from "./mission";

export interface Origin {
  latitude: number;
  longitude: number;
  /** True heading of the local frame's first axis, deg. */
  heading: number;
}

const A_M = 6378137; // WGS 84
const F = 1 / 298.257223563;
const E2 = F * (2 - F);
const RAD = Math.PI / 180;

/** The mission's origin; undefined where it has none. */
export function originOf(raw: unknown): Origin | undefined {
  const { latitude_deg, longitude_deg, heading_deg } = table(table(raw).origin);
  if (typeof latitude_deg !== "number" || typeof longitude_deg !== "number") return undefined;
  if (Math.abs(latitude_deg) > 89) return undefined;
  const heading = typeof heading_deg === "number" ? heading_deg : 0;
  return { latitude: latitude_deg, longitude: longitude_deg, heading };
}

/** Radii of the meridian and of the parallel, m. Source: NIMA TR8350.2. */
function radii(latitude: number): readonly [number, number] {
  const w2 = 1 - E2 * Math.sin(latitude * RAD) ** 2;
  return [(A_M * (1 - E2)) / w2 ** 1.5, (A_M * Math.cos(latitude * RAD)) / Math.sqrt(w2)];
}

/** Latitude and longitude, deg, of a place of the local frame, m. */
export function toEarth(origin: Origin, north: number, east: number): readonly [number, number] {
  const [c, s] = [Math.cos(origin.heading * RAD), Math.sin(origin.heading * RAD)];
  const [n, e] = [c * north - s * east, s * north + c * east];
  let latitude = origin.latitude;
  // The radius is that of the middle latitude, which it decides.
  for (let i = 0; i < 4; i++)
    latitude = origin.latitude + n / radii((latitude + origin.latitude) / 2)[0] / RAD;
  const parallel = radii((latitude + origin.latitude) / 2)[1];
  const longitude = origin.longitude + e / parallel / RAD;
  return [latitude, ((((longitude + 180) % 360) + 360) % 360) - 180];
}

/** Place of the local frame, m, of a latitude and longitude, deg. */
export function toLocal(origin: Origin, latitude: number, longitude: number): readonly [number, number] {
  const [meridian, parallel] = radii((latitude + origin.latitude) / 2);
  const turn = ((((longitude - origin.longitude + 180) % 360) + 360) % 360) - 180;
  const [n, e] = [(latitude - origin.latitude) * RAD * meridian, turn * RAD * parallel];
  const [c, s] = [Math.cos(origin.heading * RAD), Math.sin(origin.heading * RAD)];
  return [c * n + s * e, c * e - s * n];
}

/** "54.400123° N 10.200456° E" */
export function earthWords([latitude, longitude]: readonly [number, number]): string {
  const part = (value: number, plus: string, minus: string): string =>
    `${Math.abs(value).toFixed(6)}° ${value < 0 ? minus : plus}`;
  return `${part(latitude, "N", "S")} ${part(longitude, "E", "W")}`;
}

/** A degree in seven decimals: a centimetre. */
export function earthDecimals(degrees: number): number {
  return Number(degrees.toFixed(7));
}
