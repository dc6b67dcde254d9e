// The planner by keyboard: the same operations as by pointer.
import { look, showAll, size, viewport } from "./map/camera";
import { closeOutline, drawn } from "./map/outline";
import { grid, measured, TOOLS, tool } from "./map/tools";
import { panned, zoomed } from "./map/viewport";
import { short } from "./model/document";
import { EVENTS } from "./model/event_kinds";
import { along, type Ned, wrapped } from "./model/geometry";
import { save } from "./model/library";
import {
  copied,
  deleteSelected,
  dockEdits,
  insertLegs,
  nextIndex,
  paste,
  placeOf,
  reverse,
  rotateBy,
  setCurrent,
  shiftBy,
  waveEdits,
} from "./model/operations";
import { edit, letGo, mission, redo, selected, undo } from "./model/plan";
import { cornerOf, cornersOf, cornerThing, legOf, outlineAt, outlines, outlineThing } from "./model/things";

export const KEYS: readonly (readonly [keys: string, what: string])[] = [
  ["N, P", "select the next or previous thing: start, waypoints, dock, zones, faults, sea"],
  ["Arrows", "move what is selected by one step of the grid (Shift: ten steps); look around when nothing is"],
  ["Page up, Page down", "less or more depth, by 0.1 m (Shift: 1 m)"],
  [
    "[ and ]",
    "turn the selected start or dock, current or waves by 5° (Shift: 1°); zones: their corners in turn",
  ],
  ["W", "a waypoint after the selected one, or the waypoint tool when nothing is selected"],
  ["V, D, C, M", "the tools: select, dock, current, measure"],
  ["Z, B, S", "draw a keep-out zone, the keep-in boundary, the waves; Enter closes what is drawn"],
  ["Delete", "delete what is selected"],
  ["Ctrl+A, Escape", "select all, select nothing"],
  ["Ctrl+C, Ctrl+X, Ctrl+V", "copy, cut and paste waypoints"],
  ["Ctrl+Z, Ctrl+Y", "undo and redo, without end"],
  ["Ctrl+S", "save"],
  ["R", "reverse the way"],
  ["Shift+R", "turn the whole plan by 15° about its start"],
  ["+, −, F", "zoom in, out, all in view"],
];

/** Every thing that can be selected, in the order of the flight. */
export function things(): string[] {
  const view = mission.peek();
  return [
    "start",
    ...view.legs.map((_, i) => `leg:${i}`),
    ...(view.dock ? ["dock"] : []),
    ...outlines(view).map(outlineThing),
    ...EVENTS.flatMap((kind) => view.events[kind].map((_, i) => `${kind}:${i}`)),
    ...(view.wave ? ["wave"] : []),
    "current",
  ];
}

export function step(by: 1 | -1): void {
  const all = things();
  const last = selected.peek().at(-1);
  const at = last === undefined ? (by > 0 ? -1 : 0) : all.indexOf(last);
  selected.value = [all[(at + by + all.length) % all.length] ?? "start"];
}

const ARROWS: Record<string, readonly [north: number, east: number]> = {
  ArrowUp: [1, 0],
  ArrowDown: [-1, 0],
  ArrowRight: [0, 1],
  ArrowLeft: [0, -1],
};

function movable(): boolean {
  return selected.peek().some((thing) => placeOf(mission.peek(), thing));
}

function arrow([north, east]: readonly [number, number], big: boolean): void {
  if (!movable()) {
    const v = viewport.peek();
    look(panned(v, size.peek(), -60 * east, 60 * north));
    return;
  }
  const by = (grid.peek() || 0.1) * (big ? 10 : 1);
  shiftBy([north * by, east * by, 0]);
}

function turn(by: number): void {
  const view = mission.peek();
  const thing = selected.peek().at(-1);
  if (thing === "dock" && view.dock)
    edit("Turn the dock", dockEdits(view, { heading: view.dock.heading + by }), "turn dock");
  else if (thing === "start")
    edit(
      "Turn the start",
      [{ path: ["start", "heading_deg"], value: short(wrapped(view.start.heading + by), 1) }],
      "turn start",
    );
  else if (thing === "wave" && view.wave)
    edit("Turn the waves", waveEdits(view, { direction: view.wave.direction + by }), "turn wave");
  else if (thing !== undefined && outlineAt(thing) !== undefined) cornerStep(thing, by > 0 ? 1 : -1);
  else if (thing === "current") {
    const speed = Math.hypot(view.current[0], view.current[1]) || 0.05;
    const way = (Math.atan2(view.current[1], view.current[0]) * 180) / Math.PI + by;
    edit("Turn the current", setCurrent(view, along([0, 0, view.current[2]], way, speed)), "turn current");
  }
}

/** From an outline to its corners, one by one. */
function cornerStep(thing: string, by: 1 | -1): void {
  const which = outlineAt(thing);
  const count = which === undefined ? 0 : (cornersOf(mission.peek(), which)?.length ?? 0);
  if (which === undefined || count === 0) return;
  const at = cornerOf(thing)?.index ?? (by > 0 ? -1 : 0);
  selected.value = [cornerThing(which, (at + by + count) % count)];
}

/** A waypoint after the selected one: half way to the next, or 5 m on. */
export function addAfterSelected(): void {
  const view = mission.peek();
  const leg = legOf(selected.peek().at(-1) ?? "");
  const index = leg === undefined ? (selected.peek().includes("start") ? 0 : nextIndex(view)) : leg + 1;
  const before: Ned = view.legs[index - 1]?.at ?? view.start.at;
  const after = view.legs[index]?.at;
  const at: Ned = after
    ? [(before[0] + after[0]) / 2, (before[1] + after[1]) / 2, (before[2] + after[2]) / 2]
    : along(before, index > 0 ? headingInto(index - 1) : view.start.heading, 5);
  insertLegs(index, [{ at, speed: view.legs[Math.max(0, index - 1)]?.speed || view.start.speed || 0.7 }]);
}

function headingInto(leg: number): number {
  const view = mission.peek();
  const [a, b] = [view.legs[leg - 1]?.at ?? view.start.at, view.legs[leg]?.at ?? view.start.at];
  return wrapped((Math.atan2(b[1] - a[1], b[0] - a[0]) * 180) / Math.PI);
}

function withControl(event: KeyboardEvent): boolean {
  switch (event.key.toLowerCase()) {
    case "z":
      if (event.shiftKey) redo();
      else undo();
      return true;
    case "y":
      redo();
      return true;
    case "s":
      void save();
      return true;
    case "a":
      selected.value = things().filter((thing) => placeOf(mission.peek(), thing));
      return true;
    default:
      return false;
  }
}

/** Undo, redo and save anywhere in the planner but where text is typed. */
export function onAnyKey(event: KeyboardEvent): void {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const typing = (event.target as HTMLElement | null)?.closest("input, textarea, select, .yaml-editor");
  const key = event.key.toLowerCase();
  if (key === "s" || (!typing && (key === "z" || key === "y"))) {
    if (withControl(event)) event.preventDefault();
  }
}

export function onPlanKey(event: KeyboardEvent): void {
  if (event.ctrlKey || event.metaKey) {
    if (event.key.toLowerCase() === "a" && withControl(event)) event.preventDefault();
    return; // the rest bubbles: undo, redo, save; and the clipboard's own events
  }
  const arrows = ARROWS[event.key];
  if (arrows) arrow(arrows, event.shiftKey);
  else if (event.key === "PageUp" || event.key === "PageDown") {
    if (movable()) shiftBy([0, 0, (event.key === "PageDown" ? 1 : -1) * (event.shiftKey ? 1 : 0.1)]);
  } else if (!letter(event)) return;
  event.preventDefault();
}

function letter(event: KeyboardEvent): boolean {
  const by = (factor: number): void =>
    look(zoomed(viewport.peek(), size.peek(), size.peek().width / 2, size.peek().height / 2, factor));
  switch (event.key) {
    case "n":
      step(1);
      return true;
    case "p":
      step(-1);
      return true;
    case "[":
    case "{":
      turn(event.key === "{" ? -1 : -5);
      return true;
    case "]":
    case "}":
      turn(event.key === "}" ? 1 : 5);
      return true;
    case "w":
      if (selected.peek().length > 0) addAfterSelected();
      else tool.value = "waypoint";
      return true;
    case "Delete":
    case "Backspace":
      if (drawn.peek().length > 0) {
        drawn.value = drawn.peek().slice(0, -1);
        return true;
      }
      deleteSelected();
      return true;
    case "Enter":
      return closeOutline();
    case "Escape":
      letGo();
      measured.value = [];
      drawn.value = [];
      if (tool.peek() !== "select") tool.value = "select";
      else selected.value = [];
      return true;
    case "r":
      reverse();
      return true;
    case "R":
      rotateBy(15);
      return true;
    case "f":
      showAll();
      return true;
    case "+":
    case "=":
      by(1.4);
      return true;
    case "-":
      by(1 / 1.4);
      return true;
    default: {
      const wanted = TOOLS.find(({ key }) => key.toLowerCase() === event.key);
      if (wanted) tool.value = wanted.id;
      return wanted !== undefined;
    }
  }
}

/** Copy, cut and paste by the browser's own events, so that they work between tabs without asking. */
export function onClipboard(event: ClipboardEvent): void {
  const typing = (event.target as HTMLElement | null)?.closest("input, textarea, .yaml-editor");
  if (typing || !event.clipboardData) return;
  if (event.type === "paste") {
    if (paste(event.clipboardData.getData("text/plain"))) event.preventDefault();
    return;
  }
  const text = copied();
  if (!text) return;
  event.clipboardData.setData("text/plain", text);
  event.preventDefault();
  if (event.type === "cut") deleteSelected();
}
