// Which mission is open, what is stored of it, and what is only in this browser.
import { computed, effect, signal, untracked } from "@preact/signals";
import { ask } from "../../api/client";
import type { Refusal } from "../../api/http";
import { missions } from "../../api/resources";
import { dateTime } from "../../lib/format";
import { address, go } from "../../shell/address";
import { live } from "../../stream/store";
import { put, restructured } from "./document";
import { type Draft, Drafts } from "./drafts";
import { hashOf } from "./hash";
import { dragging, open, text } from "./plan";
import { blank, freeName, titleOf } from "./templates";

const drafts = new Drafts(localStorage);
const AUTOSAVE_MS = 400;

/** Name of the open mission, "" when none is. */
export const name = signal("");
/** Hash of the stored file the open text began from; "" when it was never stored. */
export const base = signal("");
export const builtin = signal(false);
export const trouble = signal<Refusal | undefined>(undefined);
/** What has just been done and can be taken back. */
export const done = signal<{ text: string; undo?: () => void } | undefined>(undefined);
export const draftNames = signal<readonly string[]>(drafts.names());
export const unkept = signal(false);
export const saving = signal(false);

export const hash = computed(() => (dragging.value ? "" : hashOf(text.value)));
export const stored = computed(() => missions.value?.find((file) => file.name === name.value));

export type Badge = "new" | "changed" | "elsewhere" | "saved" | "held" | "other";
/** How the open text stands to the stored file and to the vehicle. */
export const badge = computed<Badge>(() => {
  const file = stored.value;
  if (!file) return "new";
  if (hash.value !== file.sha256) return base.value && file.sha256 !== base.value ? "elsewhere" : "changed";
  const held = live.latest("tlm/mission")?.missionSha256;
  if (!held) return "saved";
  return held === file.sha256 ? "held" : "other";
});
export const unsaved = computed(() => ["new", "changed", "elsewhere"].includes(badge.value));

/** The mission that the address names; the open one while another view is shown. */
export function named(): string {
  return address.value.view === "plan" ? address.value.id : name.peek();
}

function take(to: string, fresh: string, from: string, own: boolean): void {
  trouble.value = undefined;
  builtin.value = own;
  base.value = from;
  open(fresh);
  name.value = to;
  if (address.peek().view === "plan") go("plan", to);
}

/** What another browser, or this one before it was cleared, left on the server. */
async function draftOfServer(wanted: string): Promise<Draft | undefined> {
  const answer = await ask("get", "/api/drafts");
  const found = answer.ok ? answer.value.find((draft) => draft.name === wanted) : undefined;
  return found && { text: found.yaml, base: "", changed: Date.parse(found.saved) };
}

/** Open a mission: its draft in this browser where there is one, else the server's, else the stored file. A shipped one has no draft. */
export async function openMission(wanted: string): Promise<void> {
  flush();
  const own = drafts.get(wanted);
  const draft = own ?? (await draftOfServer(wanted));
  const answer = await ask("get", "/api/missions/{name}", { path: { name: wanted } });
  if (untracked(named) !== wanted) return; // another was asked for since
  if (answer.ok) {
    const { yaml, sha256, builtin: shipped } = answer.value;
    const hash = sha256 || hashOf(yaml);
    if (shipped) {
      take(wanted, yaml, hash, true);
      return;
    }
    take(wanted, draft?.text ?? yaml, draft?.base || hash, false);
    if (draft && !own && draft.text !== yaml)
      done.value = {
        text: `This is the draft that the server kept at ${dateTime(draft.changed / 1000)}, not the stored file.`,
      };
  } else if (draft) take(wanted, draft.text, "", false);
  else {
    trouble.value = answer;
    name.value = "";
  }
}

export function taken(): Set<string> {
  return new Set([...(missions.peek() ?? []).map((file) => file.name), ...drafts.names()]);
}

function begin(to: string, fresh: string): void {
  flush();
  drafts.put(to, { text: fresh, base: "", changed: Date.now() });
  draftNames.value = drafts.names();
  take(to, fresh, "", false);
}

export function newMission(vehicle: string): void {
  const to = freeName("mission", taken());
  begin(to, blank(to, vehicle));
}

export function renamed(from: string, to: string): string {
  return restructured(from, (doc) => {
    put(doc, ["name"], to);
    if (doc.has("title")) put(doc, ["title"], titleOf(to));
  });
}

/** Drop a draft, here and on the server. */
export function forget(of: string): void {
  cancelFlush();
  drafts.drop(of);
  draftNames.value = drafts.names();
  void ask("delete", "/api/missions/{name}/draft", { path: { name: of } });
}

/** A copy of the open mission under a name of its own. */
export function duplicate(): void {
  const to = freeName(name.peek(), taken());
  begin(to, renamed(text.peek(), to));
}

/** A new mission that begins as a stored one. */
export async function fromTemplate(template: string): Promise<void> {
  const answer = await ask("get", "/api/missions/{name}", { path: { name: template } });
  if (!answer.ok) {
    trouble.value = answer;
    return;
  }
  const to = freeName(template, taken());
  begin(to, renamed(answer.value.yaml, to));
}

/** Store the open text. True when it is stored; the reason is in `trouble` otherwise. */
export async function save(replaceForeign = false): Promise<boolean> {
  if (saving.peek() || !name.peek()) return false;
  const [to, body, before] = [name.peek(), text.peek(), stored.peek()];
  if (before?.builtin) {
    trouble.value = refused(`${to} comes with Bumpless and stays: duplicate it to keep your changes.`);
    return false;
  }
  if (badge.peek() === "elsewhere" && !replaceForeign) return false;
  saving.value = true;
  const file = new Blob([body]);
  const path = { name: to };
  const query = replaceForeign || !base.peek() ? {} : { base: base.peek() };
  const answer = before
    ? await ask("put", "/api/missions/{name}", { path, query, body: file })
    : await ask("post", "/api/missions", { query: { name: to }, body: file });
  await missions.refresh();
  saving.value = false;
  trouble.value = answer.ok ? undefined : answer;
  if (!answer.ok) return false;
  if (name.peek() === to) base.value = answer.value.sha256;
  if (text.peek() === body) drafts.drop(to);
  draftNames.value = drafts.names();
  return true;
}

function refused(reason: string): Refusal {
  return { ok: false, status: 409, problems: [], reason };
}

/** Back to the stored file. */
export async function revert(): Promise<void> {
  const [to, kept] = [name.peek(), text.peek()];
  cancelFlush();
  drafts.drop(to);
  draftNames.value = drafts.names();
  await ask("delete", "/api/missions/{name}/draft", { path: { name: to } });
  await openMission(to);
  done.value = {
    text: "Changes discarded.",
    undo: () => {
      drafts.put(to, { text: kept, base: base.peek(), changed: Date.now() });
      void openMission(to);
    },
  };
}

/** Give the open mission another name; its file, with history and tags, goes with it. */
export async function rename(to: string): Promise<boolean> {
  const from = name.peek();
  if (to === from) return true;
  if (taken().has(to)) {
    trouble.value = refused(`There is a mission ${to} already.`);
    return false;
  }
  const fresh = renamed(text.peek(), to);
  if (!stored.peek()) {
    begin(to, fresh);
    drafts.drop(from);
    draftNames.value = drafts.names();
    return true;
  }
  const answer = await ask("post", "/api/missions/{name}/rename", { path: { name: from }, body: { to } });
  if (!answer.ok) {
    trouble.value = answer;
    return false;
  }
  await missions.refresh();
  drafts.drop(from);
  take(to, fresh, answer.value.sha256, false);
  return save();
}

/** Delete the open mission, file and draft; it can be brought back. */
export async function remove(): Promise<void> {
  const [gone, kept, had] = [name.peek(), text.peek(), stored.peek()];
  cancelFlush();
  let bin: string | undefined;
  if (had && !had.builtin) {
    const answer = await ask("delete", "/api/missions/{name}", { path: { name: gone } });
    if (!answer.ok) {
      trouble.value = answer;
      return;
    }
    bin = answer.value.id;
  } else await ask("delete", "/api/missions/{name}/draft", { path: { name: gone } });
  drafts.drop(gone);
  draftNames.value = drafts.names();
  name.value = "";
  open("");
  go("plan");
  await missions.refresh();
  done.value = {
    text: `${gone} deleted.`,
    undo: () => void (bin ? restore(bin) : begin(gone, kept)),
  };
}

async function restore(bin: string): Promise<void> {
  const answer = await ask("post", "/api/mission-bin/{binned}/restore", { path: { binned: bin } });
  await missions.refresh();
  if (!answer.ok) trouble.value = answer;
  else {
    go("plan", answer.value.name);
    await openMission(answer.value.name);
  }
}

/** A draft from a file: a mission as it is, another program's as far as it carries over. */
export async function importFile(file: File): Promise<void> {
  const plain = /\.ya?ml$/i.test(file.name);
  if (plain) {
    begin(freeName(file.name.replace(/\.ya?ml$/i, ""), taken()), await file.text());
    return;
  }
  const answer = await ask("post", "/api/missions/import", { query: { file_name: file.name }, body: file });
  if (!answer.ok) {
    trouble.value = answer;
    return;
  }
  begin(freeName(answer.value.name, taken()), answer.value.yaml);
  const left = answer.value.items
    .filter(({ carried }) => !carried)
    .map(({ what, note }) => `${what}: ${note}`);
  done.value = { text: left.length ? `Imported. ${left.join("; ")}` : "Imported, all of it." };
}

/** A new mission from a template of the server's. */
export function fromText(wanted: string, yaml: string): void {
  const to = freeName(wanted, taken());
  begin(to, renamed(yaml, to));
}

let timer: ReturnType<typeof setTimeout> | undefined;

function cancelFlush(): void {
  clearTimeout(timer);
  timer = undefined;
}

/** Keep what is open now, if it differs from what is stored. */
function flush(): void {
  if (timer === undefined) return;
  cancelFlush();
  keep();
}

function keep(): void {
  const to = name.peek();
  if (!to) return;
  if (badge.peek() === "saved" || badge.peek() === "held" || badge.peek() === "other") drafts.drop(to);
  else {
    unkept.value = !drafts.put(to, { text: text.peek(), base: base.peek(), changed: Date.now() });
    void ask("put", "/api/missions/{name}/draft", { path: { name: to }, body: new Blob([text.peek()]) });
  }
  draftNames.value = drafts.names();
}

/** Keep drafts as they are edited, and see to it that the last words are kept when the page goes. */
export function autosave(): () => void {
  const stop = effect(() => {
    void text.value;
    if (dragging.value) return;
    cancelFlush();
    if (!name.peek()) return;
    timer = setTimeout(() => {
      timer = undefined;
      keep();
    }, AUTOSAVE_MS);
  });
  addEventListener("pagehide", flush);
  return () => {
    flush();
    stop();
    removeEventListener("pagehide", flush);
  };
}
