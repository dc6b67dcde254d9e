// Which vehicle is on the bus, and what is for another one.
import { computed } from "@preact/signals";
import { live } from "./store";

/** Id of the vehicle that is on the bus, "" while none has spoken. */
export const present = computed(
  () => live.latest("tlm/description")?.vehicleId || live.latest("server/status")?.vehicleId || "",
);

/** A mission that says for which vehicle it is, and means another one than is on the bus. */
export function foreign({ vehicle }: { vehicle?: string }): boolean {
  return present.value !== "" && (vehicle ?? "") !== "" && vehicle !== present.value;
}

/** What is for this vehicle before what is for another; else as it came. */
export function ownFirst<T extends { vehicle?: string }>(list: readonly T[]): T[] {
  return [...list.filter((one) => !foreign(one)), ...list.filter((one) => foreign(one))];
}
