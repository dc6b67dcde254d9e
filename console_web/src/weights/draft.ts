// The draft: changes laid over what the vehicle flies with. Only the vehicle's own word makes a
// value active; the draft follows when the active values change under it.
import { request, type Refusal } from "../api/http";
import type { CommandReply } from "../api/types";
import { signal } from "../lib/signal";
import { live } from "../stream/store";
import { flatOfMessage, jsonOfFlat, type Flat, type Value } from "./flat";

export type Changes = Readonly<Record<string, Value>>;

export type Apply =
  | { state: "none" }
  | { state: "sending" }
  | { state: "awaiting"; revision: number; values: Flat; since: number }
  | { state: "confirmed"; revision: number; count: number }
  | { state: "differs"; revision: number; paths: string[] }
  | { state: "refused"; refusal: Refusal };

const HISTORY = 200;

export class Draft {
  apply: Apply = { state: "none" };
  readonly invalid = new Set<string>();
  private changes: Changes = {};
  private past: Changes[] = [];
  private future: Changes[] = [];
  private lastPath = "";
  private source: unknown;
  private activeFlat: Flat = {};
  private revision = 0;
  private readonly version = signal(0);

  constructor() {
    live.onChange((changed) => {
      if (changed.has("tlm/parameters")) this.followVehicle();
    });
  }

  use(): this {
    this.version.use();
    return this;
  }

  /** What the vehicle says it flies with; empty before its first word. */
  active(): Flat {
    const message = live.latest("tlm/parameters")?.active;
    if (message && message !== this.source) {
      this.source = message;
      this.activeFlat = flatOfMessage(message);
    }
    return this.activeFlat;
  }

  value(path: string): Value | undefined {
    return this.changes[path] ?? this.active()[path];
  }

  differs(path: string): boolean {
    const changed = this.changes[path];
    return changed !== undefined && changed !== this.active()[path];
  }

  changedPaths(): string[] {
    return Object.keys(this.changes).filter((path) => this.differs(path));
  }

  changeCount(): number {
    return this.changedPaths().length;
  }

  /** Edits of one field in a row are one step of undo. */
  set(path: string, value: Value): void {
    if (this.value(path) === value) return;
    const next = { ...this.changes, [path]: value };
    if (value === this.active()[path]) delete next[path];
    this.step(next, path);
  }

  revert(path: string): void {
    const { [path]: _, ...rest } = this.changes;
    this.invalid.delete(path);
    this.step(rest);
  }

  revertAll(): void {
    this.invalid.clear();
    this.step({});
  }

  /** Lay a whole set of values over the active ones, as one step of undo. */
  load(values: Flat): void {
    const active = this.active();
    const differing = Object.entries(values).filter(([path, value]) => path in active && active[path] !== value);
    this.invalid.clear();
    this.step(Object.fromEntries(differing));
  }

  endEdit(): void {
    this.lastPath = "";
  }

  canUndo(): boolean {
    return this.past.length > 0;
  }

  canRedo(): boolean {
    return this.future.length > 0;
  }

  undo(): void {
    this.travel(this.past, this.future);
  }

  redo(): void {
    this.travel(this.future, this.past);
  }

  /** The whole set that would be flown: active values with the changes laid over them. */
  whole(): Flat {
    return { ...this.active(), ...this.changes };
  }

  async send(): Promise<void> {
    const values = this.whole();
    this.setApply({ state: "sending" });
    const answer = await request<CommandReply>("PUT", "api/parameters", jsonOfFlat(values));
    if (!answer.ok) return this.setApply({ state: "refused", refusal: answer });
    const revision = Number(answer.value.revision ?? 0);
    this.setApply({ state: "awaiting", revision, values, since: performance.now() });
    this.followVehicle();
  }

  dismiss(): void {
    this.setApply({ state: "none" });
  }

  /** The vehicle spoke: drop changes that are now active, and settle an apply under way. */
  private followVehicle(): void {
    const apply = this.apply;
    const said = live.latest("tlm/parameters");
    const active = this.active();
    const revision = Number(said?.revision ?? 0);
    const anew = revision < this.revision; // another node counts from the beginning and will not reach ours
    this.revision = revision;
    if (apply.state === "awaiting" && said && (revision >= apply.revision || anew)) {
      const paths = Object.keys(apply.values).filter((path) => active[path] !== apply.values[path]);
      const count = Object.keys(this.changes).length;
      this.changes = Object.fromEntries(Object.entries(this.changes).filter(([p, v]) => active[p] !== v));
      this.past = [];
      this.future = [];
      this.setApply(
        paths.length
          ? { state: "differs", revision: apply.revision, paths }
          : { state: "confirmed", revision: apply.revision, count },
      );
    }
    this.changed();
  }

  private setApply(next: Apply): void {
    this.apply = next;
    this.changed();
  }

  private step(next: Changes, path = ""): void {
    if (!path || path !== this.lastPath) this.past = [...this.past, this.changes].slice(-HISTORY);
    this.lastPath = path;
    this.future = [];
    this.changes = next;
    if (this.apply.state !== "sending" && this.apply.state !== "awaiting") this.apply = { state: "none" };
    this.changed();
  }

  private travel(from: Changes[], to: Changes[]): void {
    const changes = from.pop();
    if (!changes) return;
    to.push(this.changes);
    this.changes = changes;
    this.invalid.clear();
    this.lastPath = "";
    this.changed();
  }

  changed(): void {
    this.version.set(this.version.get() + 1);
  }
}

export const draft = new Draft();
