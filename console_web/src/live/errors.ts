// How far the vehicle is off its references, beside the limit from which that counts as an alarm.
import { wrapDegrees } from "../stream/history";
import { inForce, screen } from "../stream/screen";
import { limits } from "./limits";

export interface TrackingError {
  name: string;
  unit: string;
  decimals: number;
  /** Believed minus reference; NaN while nothing is followed. */
  error: number;
  /** NaN while not known. */
  limit: number;
}

const less = (a: number | undefined, b: number | undefined): number => (a ?? Number.NaN) - (b ?? Number.NaN);

export function trackingErrors(): TrackingError[] {
  const followed = inForce.value;
  const nav = followed ? screen.latest("tlm/navigation") : undefined;
  const guidance = followed ? screen.latest("tlm/guidance") : undefined;
  const limit = limits.value;
  const of = (name: string, unit: string, decimals: number, error: number, most?: number): TrackingError => ({
    name,
    unit,
    decimals,
    error,
    limit: most ?? Number.NaN,
  });
  return [
    of("Depth", "m", 2, less(nav?.depthM, guidance?.depthReferenceM), limit?.depth_m),
    of("Cross-track", "m", 2, guidance?.crossTrackErrorM ?? Number.NaN, limit?.cross_track_m),
    of(
      "Heading",
      "°",
      1,
      wrapDegrees(less(nav?.attitude?.yawDeg, guidance?.attitudeReference?.yawDeg)),
      limit?.heading_deg,
    ),
    of("Speed", "m/s", 2, less(nav?.velocityBodyMps?.x, guidance?.surgeSpeedReferenceMps), limit?.speed_mps),
  ];
}
