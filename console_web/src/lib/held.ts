// On which headings station is held, as the server's rule has it: in words and figures.
import type { components } from "../gen/api";
import { fixed, headingOf } from "./format";

export type Held = components["schemas"]["HeldStation"];
export type HeldZone = Held["zone"];
type Arc = Held["arcs"][number];

/** The best first. Each has a colour and a stroke of its own: whole, broken, or thin with teeth. */
export const HELD_ZONES: readonly { zone: HeldZone; ink: string; word: string }[] = [
  { zone: "accepted", ink: "--good", word: "holds" },
  { zone: "warned", ink: "--warning", word: "may not hold" },
  { zone: "refused", ink: "--alarm", word: "can't hold" },
];
export const RAD = Math.PI / 180;
/** Headings are judged degree by degree: each stands for half a degree to either side. */
const HALF_DEG = 0.5;
const TOOTH_DEG = 8;
const STILL_MPS = 0.005;

export function heldWord(zone: HeldZone): string {
  return HELD_ZONES.find((one) => one.zone === zone)?.word ?? zone;
}

/** First heading and width of an arc, with what its ends stand for, degrees. */
export function extent({ from_deg, to_deg }: Arc): { from: number; width: number } {
  const width = (((to_deg - from_deg) % 360) + 360) % 360;
  return { from: from_deg - HALF_DEG, width: width + 2 * HALF_DEG };
}

/** "070° to 110°, 300°": the headings of a zone; "" where it has none. */
export function headingsOf(held: Held, zone: HeldZone): string {
  const three = (degrees: number): string => `${headingOf(degrees, 0).padStart(3, "0")}°`;
  return held.arcs
    .filter((arc) => arc.zone === zone)
    .map((arc) =>
      extent(arc).width >= 360
        ? "any heading"
        : arc.from_deg === arc.to_deg
          ? three(arc.from_deg)
          : `${three(arc.from_deg)} to ${three(arc.to_deg)}`,
    )
    .join(", ");
}

/** "0.10 m/s from 000°"; "no current" where it has no direction to speak of. */
export function flowWords([north = 0, east = 0]: readonly number[]): string {
  const speed = Math.hypot(north, east);
  if (speed < STILL_MPS) return "no current";
  const from = Math.atan2(-east, -north) / RAD;
  return `${fixed(speed, 2)} m/s from ${headingOf(from, 0).padStart(3, "0")}°`;
}

/** Where an arc of refused headings has a tooth, degrees. */
export function teeth(from: number, width: number): number[] {
  const count = Math.max(1, Math.floor(width / TOOTH_DEG));
  return Array.from({ length: count }, (_, i) => from + ((i + 0.5) * width) / count);
}
