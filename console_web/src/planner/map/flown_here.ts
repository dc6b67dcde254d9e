// The vehicle, while it flies the plan that is shown.
import { flying } from "../../stream/link";
import { live } from "../../stream/store";
import { badge } from "../model/library";

export interface Flown {
  north: number;
  east: number;
  depth: number;
  heading: number;
}

export function flownHere(): Flown | undefined {
  if (!flying.value || badge.value !== "held" || !live.isFresh("tlm/navigation")) return undefined;
  const navigation = live.latest("tlm/navigation");
  if (!navigation?.positionNedM) return undefined;
  const { x, y, z } = navigation.positionNedM;
  return { north: x, east: y, depth: z, heading: navigation.attitude?.yawDeg ?? 0 };
}
