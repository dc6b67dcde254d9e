// A shipped mission stays as it is: the first edit makes a copy, and undoing all of it leads back.
import { batch, effect, untracked } from "@preact/signals";
import { go } from "../../shell/address";
import { base, builtin, forget, hash, name, renamed, stored, taken } from "./library";
import { amend, broken, text } from "./plan";
import { freeName } from "./templates";

interface Copy {
  of: string;
  sha256: string;
  name: string;
  /** The text bears the copy's name; it can't while it is no YAML. */
  signed: boolean;
}

let copy: Copy | undefined;

/** Watch the open text; the answer stops it. */
export function copyOnEdit(): () => void {
  return effect(() => {
    const now = hash.value; // "" while something is dragged
    void broken.value;
    if (now && name.value) untracked(() => look(now));
  });
}

function look(now: string): void {
  if (builtin.peek() && now !== base.peek()) leave();
  else if (copy && copy.name !== name.peek()) copy = undefined;
  else if (copy && !stored.peek() && now === copy.sha256) back(copy);
  if (copy) sign(copy);
}

function leave(): void {
  copy = { of: name.peek(), sha256: base.peek(), name: freeName(name.peek(), taken()), signed: false };
  become(copy.name, "", false);
}

function back(from: Copy): void {
  copy = undefined;
  forget(from.name);
  become(from.of, from.sha256, true);
}

function become(to: string, from: string, shipped: boolean): void {
  batch(() => {
    name.value = to;
    base.value = from;
    builtin.value = shipped;
  });
  go("plan", to, {}, shipped);
}

function sign(made: Copy): void {
  if (made.signed || broken.peek()) return;
  made.signed = true;
  amend(renamed(text.peek(), made.name));
}
