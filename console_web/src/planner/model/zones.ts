// Keep-out zones and the keep-in boundary: outlines drawn corner by corner, as edits of the document.
import { type Document, isMap, isSeq, type YAMLSeq } from "yaml";
import { type Edit, put, short, styled } from "./document";
import type { Ned } from "./geometry";
import type { MissionView, Outline, Point } from "./mission";
import { mission, reshape, selected } from "./plan";
import {
  cornerOf,
  cornersOf,
  cornersPath,
  cornerThing,
  outlineThing,
  type Thing,
  type Which,
} from "./things";

export const FEWEST_CORNERS = 3;

function cornerNode(doc: Document, [north, east]: Point): unknown {
  const node = doc.createNode({ north_m: short(north), east_m: short(east) });
  if (isMap(node)) node.flow = true;
  return node;
}

function cornerList(doc: Document, corners: Outline): unknown {
  const list = doc.createNode([]) as YAMLSeq;
  list.items = corners.map((corner) => cornerNode(doc, corner)) as typeof list.items;
  list.flow = false;
  return list;
}

/** Draw a keep-out zone; the selected thing is then the zone. */
export function addZone(corners: Outline): void {
  const { keepOut } = mission.peek();
  const taken = new Set(keepOut.map(({ name }) => name));
  const name = [...Array(keepOut.length + 1).keys()].map((i) => `zone ${i + 1}`).find((n) => !taken.has(n));
  reshape("Draw a keep-out zone", (doc) => {
    if (!isSeq(doc.get("keep_out"))) put(doc, ["keep_out"], []);
    const zones = doc.get("keep_out") as YAMLSeq;
    zones.flow = false;
    const node = styled(doc, { name }) as ReturnType<Document["createNode"]>;
    if (isMap(node)) node.set("corners", cornerList(doc, corners));
    zones.add(node);
  });
  selected.value = [outlineThing(keepOut.length)];
}

/** Draw the keep-in boundary, in place of the one there is. */
export function setFence(corners: Outline): void {
  reshape("Draw the keep-in boundary", (doc) => {
    if (!isMap(doc.get("keep_in"))) doc.set("keep_in", doc.createNode({}));
    doc.setIn(["keep_in", "corners"], cornerList(doc, corners));
  });
  selected.value = ["fence"];
}

/** A new corner before corner `index`: the side that ends there is broken in two. */
export function splitSide(which: Which, index: number, at: Point): void {
  reshape("Add a corner", (doc) => {
    const corners = doc.getIn(cornersPath(which));
    if (isSeq(corners)) corners.items.splice(index, 0, cornerNode(doc, at) as (typeof corners.items)[number]);
  });
  selected.value = [cornerThing(which, index)];
}

/** Take selected outlines and corners out of a document; too few corners are no outline. */
export function removeOutlines(doc: Document, view: MissionView, things: readonly Thing[]): void {
  const gone = new Set<Which>();
  if (things.includes("fence")) gone.add("in");
  for (const thing of things) if (thing.startsWith("zone:")) gone.add(Number(thing.slice(5)));
  const corners = things.flatMap((thing) => cornerOf(thing) ?? []);
  for (const which of new Set(corners.map(({ of }) => of))) {
    const out = new Set(corners.filter(({ of }) => of === which).map(({ index }) => index));
    const left = (cornersOf(view, which)?.length ?? 0) - out.size;
    if (left < FEWEST_CORNERS) gone.add(which);
    else {
      const seq = doc.getIn(cornersPath(which));
      if (isSeq(seq)) seq.items = seq.items.filter((_, i) => !out.has(i));
    }
  }
  if (gone.has("in")) put(doc, ["keep_in"], undefined);
  const zones = doc.get("keep_out");
  if (!isSeq(zones)) return;
  zones.items = zones.items.filter((_, i) => !gone.has(i));
  if (zones.items.length === 0) put(doc, ["keep_out"], undefined);
}

/** The middle of an outline's corners. */
export function middle(corners: Outline): Point {
  const sum = corners.reduce<Point>(([n, e], corner) => [n + corner[0], e + corner[1]], [0, 0]);
  return [sum[0] / Math.max(1, corners.length), sum[1] / Math.max(1, corners.length)];
}

/** Where an outline or a corner is; the depth of a zone is that of its upper end. */
export function outlinePlace(view: MissionView, thing: Thing): Ned | undefined {
  const corner = cornerOf(thing);
  if (corner) {
    const at = cornersOf(view, corner.of)?.[corner.index];
    return at && [at[0], at[1], 0];
  }
  const which = thing === "fence" ? "in" : thing.startsWith("zone:") ? Number(thing.slice(5)) : undefined;
  const corners = which === undefined ? undefined : cornersOf(view, which);
  if (!corners) return undefined;
  return [...middle(corners), which === "in" ? 0 : (view.keepOut[which as number]?.from ?? 0)];
}

/** Edits that put an outline or a corner at a place. */
export function outlineEdits(view: MissionView, thing: Thing, to: Ned): Edit[] {
  const corner = cornerOf(thing);
  const from = outlinePlace(view, thing);
  if (!from) return [];
  if (corner) return cornerEdits(cornersPath(corner.of), corner.index, [to[0], to[1]]);
  const which: Which = thing === "fence" ? "in" : Number(thing.slice(5));
  const by: Point = [to[0] - from[0], to[1] - from[1]];
  const path = cornersPath(which);
  const still = Math.hypot(by[0], by[1]) < 1e-9;
  const edits = still
    ? []
    : (cornersOf(view, which) ?? []).flatMap(([n, e], i) => cornerEdits(path, i, [n + by[0], e + by[1]]));
  return [...edits, ...(which === "in" ? [] : depthEdits(view, which, to[2] - from[2]))];
}

function cornerEdits(path: readonly (string | number)[], index: number, to: Point): Edit[] {
  return [
    { path: [...path, index, "north_m"], value: short(to[0]) },
    { path: [...path, index, "east_m"], value: short(to[1]) },
  ];
}

function depthEdits(view: MissionView, which: number, by: number): Edit[] {
  const zone = view.keepOut[which];
  if (!zone || Math.abs(by) < 1e-9) return [];
  const edits: Edit[] = [
    { path: ["keep_out", which, "from_depth_m"], value: short(Math.max(0, zone.from + by)) },
  ];
  if (zone.to !== undefined)
    edits.push({ path: ["keep_out", which, "to_depth_m"], value: short(Math.max(0, zone.to + by)) });
  return edits;
}

/** How far a place is from an outline's nearest side, m. */
export function sideDistance(corners: Outline, [n, e]: Point): number {
  return Math.min(
    ...corners.map(([an, ae], i) => {
      const [bn, be] = corners[(i + 1) % corners.length] ?? [an, ae];
      const [dn, de] = [bn - an, be - ae];
      const share = ((n - an) * dn + (e - ae) * de) / Math.max(1e-12, dn * dn + de * de);
      const k = Math.min(1, Math.max(0, share));
      return Math.hypot(n - an - k * dn, e - ae - k * de);
    }),
  );
}

/** Whether a place lies inside an outline (even-odd). */
export function inside(corners: Outline, [n, e]: Point): boolean {
  let odd = false;
  corners.forEach(([an, ae], i) => {
    const [bn, be] = corners[(i + 1) % corners.length] ?? [an, ae];
    if (ae > e !== be > e && n < an + ((bn - an) * (e - ae)) / (be - ae)) odd = !odd;
  });
  return odd;
}
