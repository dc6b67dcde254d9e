// What can be done to a plan beyond setting a value, as edits of its document.
import { type Document, isMap, isSeq, type YAMLSeq } from "yaml";
import { type Edit, put, short, styled } from "./document";
import { removeEvents } from "./events";
import { bearing, distance, type Ned, observationPoint, rotated, shifted, wrapped } from "./geometry";
import type { Leg, MissionView } from "./mission";
import type { Path } from "./paths";
import { edit, mission, reshape, selected } from "./plan";
import { cornersOf, cornerThing, legOf, outlineAt, outlines, type Thing } from "./things";
import { outlineEdits, outlinePlace, removeOutlines } from "./zones";

const CRUISE_MPS = 0.7;
const STANDOFF_M = 1.5;
const DEPTH_M = 2;
const WAVE_PERIOD_S = 6;
/** The last leg leads to the observation point when it ends within this of it. */
const JOINED_M = 0.06;

function at(path: Path, to: Ned, before?: Ned): Edit[] {
  const rounded = to.map((v) => short(v)) as unknown as Ned;
  return rounded.flatMap((value, i) =>
    before && before[i] === value ? [] : [{ path: [...path, i], value }],
  );
}

const LEG = (i: number): Path => ["legs", i, "to_ned_m"];
const DOCK: Path = ["target", "position_ned_m"];
const START: Path = ["start", "position_ned_m"];

/** The last leg ends at the observation point, and so goes with the dock. */
export function joined(view: MissionView): boolean {
  const last = view.legs.at(-1);
  if (!view.dock || !last) return false;
  return distance(last.at, observationPoint(view.dock.at, view.dock.heading, view.dock.standoff)) < JOINED_M;
}

/** Where a thing is; the current is nowhere. */
export function placeOf(view: MissionView, thing: Thing): Ned | undefined {
  if (thing === "start") return view.start.at;
  if (thing === "dock") return view.dock?.at;
  const leg = legOf(thing);
  return leg === undefined ? outlinePlace(view, thing) : view.legs[leg]?.at;
}

/** Edits that put things at their new places; the observation point follows its dock. */
export function moveEdits(view: MissionView, places: ReadonlyMap<Thing, Ned>): Edit[] {
  const edits: Edit[] = [];
  for (const [thing, to] of places) {
    const leg = legOf(thing);
    if (outlineAt(thing) !== undefined) edits.push(...outlineEdits(view, thing, to));
    const path =
      thing === "start" ? START : thing === "dock" ? DOCK : leg === undefined ? undefined : LEG(leg);
    if (path) edits.push(...at(path, deepEnough(to), placeOf(view, thing)));
  }
  const dock = places.get("dock");
  if (dock && view.dock) edits.push(...follow(view, { ...view.dock, at: deepEnough(dock) }, places));
  return edits;
}

function deepEnough(to: Ned): Ned {
  return [to[0], to[1], Math.max(0, to[2])];
}

function follow(
  view: MissionView,
  dock: { at: Ned; heading: number; standoff: number },
  taken: ReadonlyMap<Thing, Ned> = new Map(),
): Edit[] {
  const last = view.legs.length - 1;
  if (!joined(view) || taken.has(`leg:${last}`)) return [];
  return at(LEG(last), observationPoint(dock.at, dock.heading, dock.standoff), view.legs[last]?.at);
}

/** Edits that turn the dock or set its standoff; the observation point goes along. */
export function dockEdits(view: MissionView, change: { heading?: number; standoff?: number }): Edit[] {
  if (!view.dock) return [];
  const dock = { ...view.dock, ...change };
  const edits: Edit[] = [];
  if (change.heading !== undefined)
    edits.push({ path: ["target", "heading_deg"], value: short(wrapped(change.heading), 1) });
  if (change.standoff !== undefined)
    edits.push({ path: ["target", "standoff_m"], value: short(Math.max(0, change.standoff), 2) });
  return [...edits, ...follow(view, dock)];
}

export function currentEdits(to: Ned): Edit[] {
  return [{ path: ["environment", "current_ned_mps"], value: to.map((v) => short(v)) }];
}

/** Set the current: number by number where it stands, anew where it does not. */
export function setCurrent(view: MissionView, to: Ned): Edit[] {
  const environment = (view.raw as { environment?: { current_ned_mps?: unknown } } | undefined)?.environment;
  const stands = Array.isArray(environment?.current_ned_mps);
  return stands ? at(["environment", "current_ned_mps"], to) : currentEdits(to);
}

/** Edits that change the waves; where none are, they begin with this period. */
export function waveEdits(view: MissionView, change: { height?: number; direction?: number }): Edit[] {
  const height = short(Math.max(0, change.height ?? view.wave?.height ?? 0), 2);
  const direction = short(wrapped(change.direction ?? view.wave?.direction ?? 0), 1);
  const path = ["environment", "wave"];
  if (!view.wave)
    return [{ path, value: { height_m: height, period_s: WAVE_PERIOD_S, direction_deg: direction } }];
  const edits: Edit[] = [];
  if (change.height !== undefined) edits.push({ path: [...path, "height_m"], value: height });
  if (change.direction !== undefined) edits.push({ path: [...path, "direction_deg"], value: direction });
  return edits;
}

function legsOf(doc: Document): YAMLSeq {
  const legs = doc.get("legs");
  if (isSeq(legs)) {
    if (legs.items.length === 0) legs.flow = false;
    return legs;
  }
  put(doc, ["legs"], []);
  const fresh = doc.get("legs") as YAMLSeq;
  fresh.flow = false;
  return fresh;
}

function legNode(doc: Document, leg: Leg): unknown {
  const to = leg.at.map((v) => short(v));
  const node = styled(doc, { to_ned_m: to, speed_mps: leg.speed });
  if (isMap(node)) node.flow = true;
  return node;
}

/** Insert legs before place `index`, and select their ends. */
export function insertLegs(index: number, legs: readonly Leg[], label = "Add a waypoint"): void {
  reshape(label, (doc) => {
    legsOf(doc).items.splice(index, 0, ...legs.map((leg) => legNode(doc, leg)));
  });
  selected.value = legs.map((_, i) => `leg:${index + i}`);
}

/** Where a new waypoint belongs: at the end, but before the leg that leads to the dock. */
export function nextIndex(view: MissionView): number {
  return joined(view) ? view.legs.length - 1 : view.legs.length;
}

/** A waypoint at a place, with speed and depth of the one before. */
export function addWaypoint(north: number, east: number): void {
  const view = mission.peek();
  const index = nextIndex(view);
  const before = view.legs[index - 1];
  const depth = before?.at[2] ?? view.start.at[2];
  const speed = before?.speed || view.legs[0]?.speed || view.start.speed || CRUISE_MPS;
  insertLegs(index, [{ at: [north, east, depth], speed }]);
}

/** Split a leg in its middle. */
export function splitLeg(index: number, where?: Ned): void {
  const view = mission.peek();
  const leg = view.legs[index];
  if (!leg) return;
  const from = view.legs[index - 1]?.at ?? view.start.at;
  const middle = leg.at.map((v, i) => (v + (from[i] ?? v)) / 2) as unknown as Ned;
  insertLegs(index, [{ at: where ?? middle, speed: leg.speed }], "Split a leg");
}

/** Put the dock at a place; with it the leg that leads to its observation point. */
export function placeDock(place: Ned, heading?: number): void {
  const view = mission.peek();
  if (view.dock) {
    const turned = heading === undefined ? view.dock.heading : heading;
    const dock = { ...view.dock, at: place, heading: turned };
    edit("Place the dock", [
      ...at(DOCK, place, view.dock.at),
      { path: ["target", "heading_deg"], value: short(wrapped(turned), 1) },
      ...follow(view, dock),
    ]);
  } else {
    const last = view.legs.at(-1);
    const from = last?.at ?? view.start.at;
    const turned = short(wrapped(heading ?? Math.round(bearing(from, place))), 1);
    const speed = last?.speed || view.start.speed || CRUISE_MPS;
    const target = {
      position_ned_m: place.map((v) => short(v)),
      heading_deg: turned,
      standoff_m: STANDOFF_M,
    };
    reshape("Place the dock", (doc) => {
      put(doc, ["target"], target);
      const end = observationPoint(place, turned, STANDOFF_M);
      if (distance(from, end) > 1) legsOf(doc).items.push(legNode(doc, { at: end, speed }));
    });
  }
  selected.value = ["dock"];
}

export function defaultDepth(view: MissionView): number {
  return view.legs.at(-1)?.at[2] ?? (view.start.at[2] || DEPTH_M);
}

/** Delete what is selected: waypoints go, the current is stilled, the dock is taken up. */
export function deleteSelected(): void {
  const things = selected.peek();
  const legs = things.map(legOf).filter((i): i is number => i !== undefined);
  if (things.length === 0 || things.every((thing) => thing === "start")) return;
  const view = mission.peek();
  reshape(legs.length > 1 ? `Delete ${legs.length} waypoints` : "Delete", (doc) => {
    const seq = doc.get("legs");
    if (isSeq(seq)) seq.items = seq.items.filter((_, i) => !legs.includes(i));
    if (things.includes("current")) put(doc, ["environment", "current_ned_mps"], undefined);
    if (things.includes("wave")) put(doc, ["environment", "wave"], undefined);
    if (things.includes("dock")) put(doc, ["target"], undefined);
    removeOutlines(doc, view, things);
    removeEvents(doc, things);
  });
  selected.value = [];
}

const clipboardKey = "bumpless-legs:";

/** Selected waypoints as text that any tab can paste. */
export function copied(): string | undefined {
  const view = mission.peek();
  const legs = selectedLegs().map((i) => view.legs[i]);
  return legs.length ? clipboardKey + JSON.stringify(legs) : undefined;
}

export function selectedLegs(): number[] {
  return selected
    .peek()
    .map(legOf)
    .filter((i): i is number => i !== undefined)
    .sort((a, b) => a - b);
}

export function paste(text: string): boolean {
  if (!text.startsWith(clipboardKey)) return false;
  const legs = JSON.parse(text.slice(clipboardKey.length)) as Leg[];
  const moved = legs.map((leg) => ({ ...leg, at: shifted(leg.at, [2, 2, 0]) }));
  const last = selectedLegs().at(-1);
  insertLegs(last === undefined ? nextIndex(mission.peek()) : last + 1, moved, "Paste");
  return true;
}

/** Fly the way back: the start changes places with the last free waypoint, the dock stays. */
export function reverse(): void {
  const view = mission.peek();
  const count = nextIndex(view);
  if (count < 1) return;
  const points = [view.start.at, ...view.legs.slice(0, count).map((leg) => leg.at)].reverse();
  const [first, ...rest] = points as [Ned, ...Ned[]];
  const edits = at(START, first);
  rest.forEach((point, i) => {
    edits.push(...at(LEG(i), point));
  });
  if (rest[0]) edits.push({ path: ["start", "heading_deg"], value: short(bearing(first, rest[0]), 1) });
  edit("Reverse the way", edits);
}

function all(view: MissionView): Map<Thing, Ned> {
  const places = new Map<Thing, Ned>([["start", view.start.at]]);
  view.legs.forEach((leg, i) => {
    places.set(`leg:${i}`, leg.at);
  });
  if (view.dock) places.set("dock", view.dock.at);
  for (const which of outlines(view))
    cornersOf(view, which)?.forEach(([n, e], i) => {
      places.set(cornerThing(which, i), [n, e, 0]);
    });
  return places;
}

/** What a change applies to: the selected things that have a place, or the whole plan. */
export function scope(view: MissionView): Map<Thing, Ned> {
  const chosen = selected.peek().flatMap((thing) => {
    const place = placeOf(view, thing);
    return place ? [[thing, place] as const] : [];
  });
  return chosen.length > 0 ? new Map(chosen) : all(view);
}

export function shiftBy(by: Ned, things?: Map<Thing, Ned>): void {
  const view = mission.peek();
  const places = things ?? scope(view);
  const edits = moveEdits(view, new Map([...places].map(([id, p]) => [id, shifted(p, by)])));
  edit("Move", edits, `shift ${[...places.keys()].join()}`);
}

/** Turn the whole plan, headings and current's frame excepted, about its start. */
export function rotateBy(degrees: number): void {
  const view = mission.peek();
  const places = all(view);
  const turned = new Map([...places].map(([id, p]) => [id, rotated(p, view.start.at, degrees)]));
  const edits = moveEdits(view, turned);
  edits.push({ path: ["start", "heading_deg"], value: short(wrapped(view.start.heading + degrees), 1) });
  if (view.dock)
    edits.push({ path: ["target", "heading_deg"], value: short(wrapped(view.dock.heading + degrees), 1) });
  edit("Turn the plan", edits, "rotate");
}
