// What the actuators can do at the present speed: asked of the server per step of speed, kept.
import { computed, effect, signal, untracked } from "@preact/signals";
import { ask } from "../api/client";
import type { components } from "../gen/api";
import type { Wrench } from "../gen/bumpless_pb";
import { WRENCH_AXES, type WrenchAxis, wrenchOf } from "../lib/wrench";
import { screen } from "../stream/screen";

export type Reach = components["schemas"]["ReachAnswer"];

/** Between the speeds that are asked for, m/s: the server keeps sets at these steps too. */
const STEP_MPS = 0.1;
const MOST_KEPT = 80;

const kept = signal<ReadonlyMap<string, Reach>>(new Map());
const asking = new Set<string>();

const vehicle = computed(() => screen.latest("tlm/description")?.sha256 ?? "");
const bin = computed(() => {
  const nav = screen.latest("tlm/navigation");
  const speed = nav?.velocityThroughWaterBodyMps?.x ?? nav?.velocityBodyMps?.x;
  return speed !== undefined && Number.isFinite(speed) ? Math.round(speed / STEP_MPS) : undefined;
});
let last: Reach | undefined;

/** The sets at the present speed; while they are on their way those of the speed before. */
export const reach = computed((): Reach | undefined => {
  const found = kept.value.get(`${vehicle.value}/${bin.value}`);
  if (found) last = found;
  return found ?? (last && keptOf === vehicle.value ? last : undefined);
});
let keptOf = "";

async function load(sha: string, step: number): Promise<void> {
  const key = `${sha}/${step}`;
  if (asking.has(key) || kept.peek().has(key)) return;
  asking.add(key);
  const answer = await ask("get", "/api/vehicle/reach", { query: { surge_mps: step * STEP_MPS } });
  asking.delete(key);
  if (!answer.ok || vehicle.peek() !== sha) return;
  if (keptOf !== sha || kept.peek().size >= MOST_KEPT) kept.value = new Map();
  keptOf = sha;
  kept.value = new Map(kept.peek()).set(key, answer.value);
}

let stop: (() => void) | undefined;
let lookers = 0;

/** Keep the sets up to date while somebody looks; returns how to stop. */
export function watchReach(): () => void {
  lookers += 1;
  stop ??= effect(() => {
    const [sha, step] = [vehicle.value, bin.value];
    if (sha && step !== undefined) untracked(() => void load(sha, step));
  });
  return () => {
    lookers -= 1;
    if (lookers) return;
    stop?.();
    stop = undefined;
  };
}

/** Largest along an axis at any speed, N or N·m; 0 while not known. */
export function reachOf(axis: WrenchAxis): number {
  return reach.value?.most[WRENCH_AXES.indexOf(axis)] ?? 0;
}

const NOTHING = 1e-6; // of the most that an axis ever has

/** 1 where something acts along an axis now, 0 where nothing does: no row bounds the set there, and it has no width. */
export function acts(of: Reach, axis: number): 0 | 1 {
  const least = NOTHING * (of.most[axis] ?? 0);
  return Math.max(of.high[axis] ?? 0, -(of.low[axis] ?? 0)) > least ? 1 : 0;
}

/** What a demand leaves of the sets in its own direction, 0 to 1; undefined while not known. */
export function marginOf(demand: Wrench | undefined, of: Reach | undefined): number | undefined {
  if (!demand || !of) return undefined;
  const parts = WRENCH_AXES.map((axis) => wrenchOf(demand, axis) ?? Number.NaN);
  if (parts.some(Number.isNaN)) return undefined;
  const used = Math.max(gauge(of.force, parts.slice(0, 3)), gauge(of.moment, parts.slice(3)));
  return Math.max(0, Math.min(1, 1 - used));
}

/** By how much a set must be scaled to just hold a demand. */
export function gauge(rows: readonly number[][], [a = 0, b = 0, c = 0]: readonly number[]): number {
  let most = 0;
  for (const [x = 0, y = 0, z = 0] of rows) most = Math.max(most, x * a + y * b + z * c);
  return most;
}

/**
 * Cut of a set by the plane of two of its axes, at `at` along the third: a closed line about the origin.
 * Where the plane misses the set the cut is empty.
 */
export function slice(
  rows: readonly number[][],
  first: number,
  second: number,
  at: number,
  points = 96,
): [number, number][] {
  const third = 3 - first - second;
  const cut: [number, number][] = [];
  for (let k = 0; k < points; k++) {
    const angle = (2 * Math.PI * k) / points;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    let far = Number.POSITIVE_INFINITY;
    for (const row of rows) {
      const room = 1 - (row[third] ?? 0) * at;
      const along = (row[first] ?? 0) * c + (row[second] ?? 0) * s;
      if (room < 0) return [];
      if (along > 1e-9) far = Math.min(far, room / along);
    }
    cut.push(Number.isFinite(far) ? [far * c, far * s] : [0, 0]);
  }
  return cut;
}
