// Faults of actuators and outages of sensors: what fails, from when to when, as edits of the document.
import { type Document, isMap, isSeq, type YAMLSeq } from "yaml";
import { type Edit, put, short, styled } from "./document";
import { EVENTS, type EventKind } from "./event_kinds";
import type { MissionView } from "./mission";
import { edit, mission, reshape, selected } from "./plan";
import { EVENT_PATHS, eventOf, type Thing } from "./things";

const LASTS_S = 10; // a new outage

/** Where in the document the begin of an event stands. */
function beginOf(kind: EventKind): string {
  return kind === "fault" ? "at_s" : "from_s";
}

/** Add a fault or an outage at a time, and select it. */
export function addEvent(kind: EventKind, at: number, actuator = ""): void {
  const path = EVENT_PATHS[kind];
  const count = mission.peek().events[kind].length;
  const from = short(at, 1);
  const value =
    kind === "fault"
      ? { actuator, at_s: from, effectiveness: 0 }
      : { from_s: from, to_s: short(from + LASTS_S, 1) };
  reshape(kind === "fault" ? "Add a fault" : "Add an outage", (doc) => {
    if (!isSeq(doc.getIn(path))) put(doc, path, []);
    const list = doc.getIn(path) as YAMLSeq;
    list.flow = false;
    const node = styled(doc, value);
    if (isMap(node)) node.flow = true;
    list.items.push(node as (typeof list.items)[number]);
  });
  selected.value = [`${kind}:${count}`];
}

export type Edge = "from" | "to" | "both";

/** Edits that move the begin, the end or the whole of an event to where its begin (or end) is at `to`, s. */
export function eventEdits(view: MissionView, thing: Thing, edge: Edge, to: number): Edit[] {
  const found = eventOf(thing);
  const event = found && view.events[found.kind][found.index];
  if (!found || !event) return [];
  const path = [...EVENT_PATHS[found.kind], found.index];
  const begin = (value: number): Edit => ({ path: [...path, beginOf(found.kind)], value: short(value, 2) });
  const end = (value: number): Edit => ({ path: [...path, "to_s"], value: short(value, 2) });
  const least = Math.max(0, to);
  if (event.to === undefined) return edge === "to" ? [] : [begin(least)];
  if (edge === "from") return [begin(Math.min(least, event.to))];
  if (edge === "to") return [end(Math.max(least, event.from))];
  return [begin(least), end(least + event.to - event.from)];
}

/** Move an event by keys. */
export function nudgeEvent(thing: Thing, edge: Edge, by: number): void {
  const found = eventOf(thing);
  const event = found && mission.peek().events[found.kind][found.index];
  if (!event) return;
  const from = edge === "to" ? (event.to ?? event.from) : event.from;
  edit("Change a time", eventEdits(mission.peek(), thing, edge, from + by), `event ${thing} ${edge}`);
}

/** Take selected events out of a document. */
export function removeEvents(doc: Document, things: readonly Thing[]): void {
  for (const kind of EVENTS) {
    const gone = new Set(
      things.flatMap((thing) => {
        const found = eventOf(thing);
        return found?.kind === kind ? [found.index] : [];
      }),
    );
    const list = doc.getIn(EVENT_PATHS[kind]);
    if (gone.size === 0 || !isSeq(list)) continue;
    list.items = list.items.filter((_, i) => !gone.has(i));
    if (list.items.length === 0) put(doc, EVENT_PATHS[kind], undefined);
  }
}
