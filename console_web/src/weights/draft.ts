// The draft: changes laid over what the vehicle flies with. Only the vehicle's own word makes a
// value active; the draft follows when the active values change under it.
import { batch, computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { ask } from "../api/client";
import type { Answer, Refusal } from "../api/http";
import type { CommandReply } from "../api/types";
import type { ParametersStatus } from "../gen/bumpless_pb";
import { live } from "../stream/store";
import { type Flat, flatOfMessage, jsonOfFlat, type Value } from "./flat";

export type Changes = Readonly<Record<string, Value>>;

export type Apply =
  | { state: "none" }
  | { state: "sending" }
  | { state: "awaiting"; revision: number; values: Flat; since: number }
  | { state: "confirmed"; revision: number; count: number }
  | { state: "differs"; revision: number; paths: string[] }
  | { state: "refused"; refusal: Refusal };

/** What goes with a change: the revision it was made from, why, and which request it is. */
export interface Sent {
  revision: number | undefined;
  reason: string;
  key: string;
}

type Put = (parameters: object, sent: Sent) => Promise<Answer<CommandReply>>;
const STEPS_KEPT = 200;

function newKey(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  return [...bytes].map((n) => n.toString(16).padStart(2, "0")).join("");
}

export class Draft {
  readonly apply = signal<Apply>({ state: "none" });
  /** Paths whose field holds no number. */
  readonly invalid = signal<ReadonlySet<string>>(new Set());
  /** What the vehicle says it flies with; empty before its first word. */
  readonly active: ReadonlySignal<Flat>;
  readonly changedPaths = computed(() =>
    Object.keys(this.changes.value).filter((path) => this.differs(path)),
  );
  readonly canUndo = computed(() => this.past.value.length > 0);
  readonly canRedo = computed(() => this.future.value.length > 0);
  private readonly changes = signal<Changes>({});
  private readonly past = signal<readonly Changes[]>([]);
  private readonly future = signal<readonly Changes[]>([]);
  /** Revision of the active values that the first change was made from; undefined without one. */
  readonly basis = signal<number | undefined>(undefined);
  /** Why, for the record. */
  readonly reason = signal("");
  private lastPath = "";
  private revision = 0;
  private tried: { key: string; body: string } | undefined;

  constructor(
    private readonly said: ReadonlySignal<ParametersStatus | undefined>,
    private readonly put: Put,
  ) {
    this.active = computed(() => {
      const message = said.value?.active;
      return message ? flatOfMessage(message) : {};
    });
    effect(() => {
      void said.value;
      untracked(() => this.followVehicle());
    });
  }

  value(path: string): Value | undefined {
    return this.changes.value[path] ?? this.active.value[path];
  }

  differs(path: string): boolean {
    const changed = this.changes.value[path];
    return changed !== undefined && changed !== this.active.value[path];
  }

  /** Edits of one field in a row are one step of undo. */
  set(path: string, value: Value): void {
    if (this.value(path) === value) return;
    const { [path]: _, ...rest } = this.changes.value;
    this.step(value === this.active.value[path] ? rest : { ...rest, [path]: value }, path);
  }

  /** The field of `path` holds a number, or does not. */
  setValid(path: string, valid: boolean): void {
    if (this.invalid.value.has(path) !== valid) return;
    const next = new Set(this.invalid.value);
    if (valid) next.delete(path);
    else next.add(path);
    this.invalid.value = next;
  }

  revert(path: string): void {
    const { [path]: _, ...rest } = this.changes.value;
    this.setValid(path, true);
    this.step(rest);
  }

  revertAll(): void {
    this.invalid.value = new Set();
    this.step({});
  }

  /** Lay a whole set of values over the active ones, as one step of undo. */
  load(values: Flat): void {
    const active = this.active.value;
    const differing = Object.entries(values).filter(
      ([path, value]) => path in active && active[path] !== value,
    );
    this.invalid.value = new Set();
    this.step(Object.fromEntries(differing));
  }

  endEdit(): void {
    this.lastPath = "";
  }

  undo(): void {
    this.travel(this.past, this.future);
  }

  redo(): void {
    this.travel(this.future, this.past);
  }

  /** Every value as it would fly. */
  whole(): Flat {
    return { ...this.active.value, ...this.changes.value };
  }

  /** The vehicle flies other values than those that the draft was made from. */
  readonly outdated = computed(
    () => this.basis.value !== undefined && this.basis.value !== Number(this.said.value?.revision ?? 0),
  );

  /** Keep the changes, now over what the vehicle flies with since. */
  rebase(): void {
    this.basis.value = this.basis.value === undefined ? undefined : Number(this.said.value?.revision ?? 0);
    this.dismiss();
  }

  async send(): Promise<void> {
    const values = this.whole();
    const body = jsonOfFlat(values);
    this.apply.value = { state: "sending" };
    const sent = { revision: this.basis.value, reason: this.reason.value.trim(), key: this.keyOf(body) };
    const answer = await this.put(body, sent);
    if (!answer.ok) {
      if (answer.status) this.tried = undefined; // answered: the next try is another request
      this.apply.value = { state: "refused", refusal: answer };
      return;
    }
    this.tried = undefined;
    this.reason.value = "";
    this.apply.value = {
      state: "awaiting",
      revision: answer.value.revision,
      values,
      since: performance.now(),
    };
    this.followVehicle();
  }

  /** One request keeps its key until it is answered: tried again, it is not carried out twice. */
  private keyOf(parameters: object): string {
    const body = JSON.stringify(parameters);
    if (this.tried?.body !== body) this.tried = { key: newKey(), body };
    return this.tried.key;
  }

  dismiss(): void {
    this.apply.value = { state: "none" };
  }

  /** The vehicle spoke: drop changes that are now active, and settle an apply under way. */
  private followVehicle(): void {
    const apply = this.apply.value;
    const said = this.said.value;
    const revision = Number(said?.revision ?? 0);
    const anew = revision < this.revision; // another node counts from the beginning and will not reach ours
    this.revision = revision;
    if (anew && this.basis.value !== undefined) this.basis.value = revision;
    if (apply.state !== "awaiting" || !said || !(revision >= apply.revision || anew)) return;
    const active = this.active.value;
    const paths = Object.keys(apply.values).filter((path) => active[path] !== apply.values[path]);
    const count = Object.keys(this.changes.value).length;
    batch(() => {
      const open = Object.entries(this.changes.value).filter(([path, value]) => active[path] !== value);
      this.changes.value = Object.fromEntries(open);
      this.basis.value = open.length ? revision : undefined;
      this.past.value = [];
      this.future.value = [];
      this.apply.value = paths.length
        ? { state: "differs", revision: apply.revision, paths }
        : { state: "confirmed", revision: apply.revision, count };
    });
  }

  private step(next: Changes, path = ""): void {
    batch(() => {
      if (!path || path !== this.lastPath)
        this.past.value = [...this.past.value, this.changes.value].slice(-STEPS_KEPT);
      this.lastPath = path;
      this.future.value = [];
      this.changes.value = next;
      this.note();
      const { state } = this.apply.value;
      if (state !== "sending" && state !== "awaiting") this.dismiss();
    });
  }

  /** The first change is made from what is in force now. */
  private note(): void {
    const any = Object.keys(this.changes.value).length > 0;
    this.basis.value = any ? (this.basis.value ?? Number(this.said.value?.revision ?? 0)) : undefined;
  }

  private travel(from: typeof this.past, to: typeof this.past): void {
    const changes = from.value.at(-1);
    if (!changes) return;
    batch(() => {
      from.value = from.value.slice(0, -1);
      to.value = [...to.value, this.changes.value];
      this.changes.value = changes;
      this.note();
      this.invalid.value = new Set();
      this.lastPath = "";
    });
  }
}

export const draft = new Draft(
  computed(() => live.latest("tlm/parameters")),
  (body, { revision, reason, key }) =>
    ask("put", "/api/parameters", {
      body,
      headers: {
        "idempotency-key": key,
        ...(revision === undefined ? {} : { "if-match": `"${revision}"` }),
        ...(reason ? { "x-reason": encodeURIComponent(reason) } : {}),
      },
    }),
);
