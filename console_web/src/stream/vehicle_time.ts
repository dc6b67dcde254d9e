// The vehicle's clock may be hours off the server's: what it says of when is shown by the server's.
import type { Event } from "../gen/bumpless_pb";

/** Nearer than this the clocks count as one: the offset is measured through the link's delay. */
const SAME_S = 0.5;

/** UNIX time of an event by the server's clock, ms; `offsetS`: the vehicle's clock minus the server's. */
export function whenMs(event: Event, offsetS: number): number | undefined {
  if (!event.stamp?.timeNs) return undefined;
  const said = Number(event.stamp.timeNs / 1_000_000n);
  const byVehicle = event.details.source !== "server" && Math.abs(offsetS) >= SAME_S;
  return byVehicle ? said - offsetS * 1000 : said;
}
