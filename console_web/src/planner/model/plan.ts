// The one document that all views show and edit: its text, what it means, what is selected, and its history.
import { batch, computed, signal } from "@preact/signals";
import type { Document } from "yaml";
import { type Edit, edited, patched, read, restructured } from "./document";
import { History } from "./history";
import { type MissionView, missionView } from "./mission";
import { exists, type Thing } from "./things";

interface State {
  text: string;
  /** The text's plain value; the last one that could be read while the text can't. */
  raw: unknown;
  /** Why the text is no YAML; its place as an offset. */
  broken: { reason: string; at: number } | undefined;
  doc: Document | undefined;
}

function stateOf(text: string, before?: State): State {
  const doc = read(text);
  const [error] = doc.errors;
  if (error) {
    return { text, raw: before?.raw, broken: { reason: error.message, at: error.pos[0] }, doc };
  }
  return { text, raw: doc.toJS({ maxAliasCount: 100 }), broken: undefined, doc };
}

const state = signal<State>(stateOf(""));
let history = new History("");
const moves = signal(0); // of the history, which is no signal itself
let held: State | undefined; // as it was when a drag began

export const text = computed(() => state.value.text);
export const broken = computed(() => state.value.broken);
export const mission = computed(() => missionView(state.value.raw));
/** A plan without a way or a dock is not flown: the next step says what is missing. */
export const flies = computed(() => mission.value.legs.length > 0 && mission.value.dock !== undefined);
export const selected = signal<readonly Thing[]>([]);
/** Something is being dragged: what is costly waits. */
export const dragging = signal(false);
export const undoLabel = computed(() => {
  void moves.value;
  return history.back;
});
export const redoLabel = computed(() => {
  void moves.value;
  return history.forth;
});

function show(next: State): void {
  batch(() => {
    state.value = next;
    moves.value = moves.peek() + 1;
  });
}

/** The document of the text as it stands. */
export function documentNow(): Document {
  const now = state.peek();
  now.doc ??= read(now.text);
  return now.doc;
}

/** Begin anew with another text; nothing before it can be undone. */
export function open(fresh: string): void {
  history = new History(fresh);
  held = undefined;
  batch(() => {
    dragging.value = false;
    selected.value = [];
    show(stateOf(fresh));
  });
}

/** Take a whole text as the new state, as typed. */
export function setText(next: string, label: string, key?: string): void {
  if (next === state.peek().text) return;
  history.add(next, label, key);
  show(stateOf(next, state.peek()));
}

/** What follows from the last edit, taken back with it. */
export function amend(next: string): void {
  if (next === state.peek().text) return;
  history.amend(next);
  show(stateOf(next, state.peek()));
}

/** Change values. Edits with the same key that follow each other are undone as one. */
export function edit(label: string, edits: readonly Edit[], key?: string): void {
  if (edits.length === 0 || state.peek().broken) return;
  setText(edited(state.peek().text, edits, documentNow()), label, key);
}

/** Change the structure. */
export function reshape(label: string, change: (doc: Document) => void): void {
  if (state.peek().broken) return;
  setText(restructured(state.peek().text, change), label);
}

/** Show edits of what stood when the drag began, without a step in the history. */
export function drag(make: (before: MissionView) => readonly Edit[]): void {
  held ??= { ...state.peek(), doc: documentNow() };
  if (held.broken) return;
  const from = held;
  const edits = make(missionView(from.raw));
  batch(() => {
    dragging.value = true;
    show({
      text: edited(from.text, edits, from.doc),
      raw: patched(from.raw, edits),
      broken: undefined,
      doc: undefined,
    });
  });
}

/** The drag is over: one step. */
export function drop(label: string): void {
  if (!held) return;
  held = undefined;
  const { text: now } = state.peek();
  history.add(now, label);
  batch(() => {
    dragging.value = false;
    show(stateOf(now));
  });
}

/** The drag is given up: all as before. */
export function letGo(): void {
  if (!held) return;
  const before = held;
  held = undefined;
  batch(() => {
    dragging.value = false;
    show(before);
  });
}

function restore(to: string | undefined): void {
  if (to === undefined) return;
  batch(() => {
    show(stateOf(to, state.peek()));
    selected.value = selected.peek().filter((thing) => exists(mission.peek(), thing));
  });
}

export function undo(): void {
  letGo();
  restore(history.undo());
}

export function redo(): void {
  letGo();
  restore(history.redo());
}
