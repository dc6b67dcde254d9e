// What can be selected, by name: "start", "leg:2", "dock", "current", "wave", "zone:0", "fence" (the keep-in
// boundary), "corner:0.3" and "corner:in.3", "fault:0", "outage:0" (of sight), "dvl:0" (of the Doppler log).
import { EVENTS, type EventKind } from "./event_kinds";
import type { MissionView, Outline } from "./mission";
import type { Path } from "./paths";

export type Thing = string;
/** An outline: a keep-out zone by its place in the list, or the keep-in boundary. */
export type Which = number | "in";

/** Index of a leg's thing. */
export function legOf(thing: Thing): number | undefined {
  return indexed(thing, "leg");
}

function indexed(thing: Thing, kind: string): number | undefined {
  return thing.startsWith(`${kind}:`) ? Number(thing.slice(kind.length + 1)) : undefined;
}

/** The outline that a thing is, as a whole. */
export function outlineOf(thing: Thing): Which | undefined {
  return thing === "fence" ? "in" : indexed(thing, "zone");
}

export function cornerOf(thing: Thing): { of: Which; index: number } | undefined {
  const found = /^corner:(in|\d+)\.(\d+)$/.exec(thing);
  if (!found) return undefined;
  return { of: found[1] === "in" ? "in" : Number(found[1]), index: Number(found[2]) };
}

/** The outline that a thing is or is a corner of. */
export function outlineAt(thing: Thing): Which | undefined {
  return outlineOf(thing) ?? cornerOf(thing)?.of;
}

export function outlineThing(which: Which): Thing {
  return which === "in" ? "fence" : `zone:${which}`;
}

export function cornerThing(which: Which, index: number): Thing {
  return `corner:${which}.${index}`;
}

export function cornersPath(which: Which): Path {
  return which === "in" ? ["keep_in", "corners"] : ["keep_out", which, "corners"];
}

export function cornersOf(view: MissionView, which: Which): Outline | undefined {
  return which === "in" ? view.keepIn : view.keepOut[which]?.corners;
}

/** Every outline of a plan that has one. */
export function outlines(view: MissionView): Which[] {
  return [...view.keepOut.map((_, i) => i), ...(view.keepIn ? (["in"] as const) : [])];
}

export function eventOf(thing: Thing): { kind: EventKind; index: number } | undefined {
  for (const kind of EVENTS) {
    const index = indexed(thing, kind);
    if (index !== undefined) return { kind, index };
  }
  return undefined;
}

export const EVENT_PATHS: Record<EventKind, Path> = {
  fault: ["faults"],
  outage: ["sensors", "outages"],
  dvl: ["sensors", "dvl_outages"],
};

/** Whether a thing is still there: an undo may have taken it away. */
export function exists(view: MissionView, thing: Thing): boolean {
  const [leg, corner, outline, event] = [legOf(thing), cornerOf(thing), outlineOf(thing), eventOf(thing)];
  if (leg !== undefined) return leg < view.legs.length;
  if (corner) return corner.index < (cornersOf(view, corner.of)?.length ?? 0);
  if (outline !== undefined) return cornersOf(view, outline) !== undefined;
  if (event) return event.index < view.events[event.kind].length;
  return thing !== "wave" || view.wave !== undefined;
}
