// What a new mission begins with: just enough that the first click on the water makes sense.

export interface Template {
  id: string;
  title: string;
  about: string;
}

/** Room for the slowest plans of a tank or a harbour, and for a second approach; the operator changes it. */
const DURATION_S = 300;
/** In place for so long is docked, and the mission over: nobody waits for the rest of the time. */
const HOVER_S = 10;

export function blank(name: string, vehicle: string): string {
  return `version: 1
name: ${name}
title: ${titleOf(name)}
vehicle: ${vehicle}
duration_s: ${DURATION_S}
seed: 1

# Positions are NED: [north, east, down] in metres, depth positive down.
start:
  position_ned_m: [0, 0, 2]
  heading_deg: 0
  speed_mps: 0.7
legs: []
end:
  hover_hold_s: ${HOVER_S}
`;
}

export function titleOf(name: string): string {
  const words = name.replace(/[_-]+/g, " ").trim();
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** A name that no mission has yet: name, name_2, name_3. */
export function freeName(wanted: string, taken: ReadonlySet<string>): string {
  const base =
    wanted
      .replace(/[^A-Za-z0-9_-]+/g, "_")
      .replace(/^[^A-Za-z0-9]+/, "")
      .slice(0, 56) || "mission";
  if (!taken.has(base)) return base;
  const stem = base.replace(/_\d+$/, "");
  for (let i = 2; ; i++) if (!taken.has(`${stem}_${i}`)) return `${stem}_${i}`;
}
