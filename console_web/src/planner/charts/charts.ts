// Charts of the site and of the open mission: which there are, which are looked at, and what they show.
import { computed, effect, signal, untracked } from "@preact/signals";
import { address, ask } from "../../api/client";
import type { Refusal } from "../../api/http";
import { Resource } from "../../api/resource";
import type { components } from "../../gen/api";
import { originOf } from "../model/earth";
import { name } from "../model/library";
import { mission } from "../model/plan";

type Schemas = components["schemas"];
export type ChartSummary = Schemas["ChartSummary"];
export type ChartShown = Schemas["ChartShown"];
export type ChartFeature = Schemas["ChartFeature"];
export type ChartDepths = Schemas["ChartDepths"];

/** What is drawn of a chart. */
export interface Drawn {
  shown: ChartShown;
  /** Of a picture, once it is here. */
  picture: HTMLImageElement | undefined;
}

const KEY = "bumpless.plan.charts.hidden";

function isHere({ missions }: ChartSummary, open: string): boolean {
  return missions.length === 0 || missions.includes(open);
}

function kept(): string[] {
  try {
    const found: unknown = JSON.parse(localStorage.getItem(KEY) ?? "[]");
    return Array.isArray(found) ? found.map(String) : [];
  } catch {
    return [];
  }
}

export const charts = new Resource(() => ask("get", "/api/charts"));
/** The site's, and those of the open mission. */
export const chartsHere = computed(() => charts.value?.filter((chart) => isHere(chart, name.value)));
/** Those that belong to other missions. */
export const chartsElsewhere = computed(() =>
  (charts.value ?? []).filter((chart) => !isHere(chart, name.value)),
);
export const hidden = signal<readonly string[]>(kept());
export const chartTrouble = signal<Refusal | undefined>(undefined);
const got = signal<ReadonlyMap<string, Drawn>>(new Map());

/** The mission's sea floor, as the chart it names. */
export const floorChart = computed(() => {
  const floor = (mission.value.raw as { sea_floor?: { grid?: unknown } } | undefined)?.sea_floor;
  return typeof floor?.grid === "string" ? floor.grid : "";
});

/** What is drawn beneath the plan: depths first, then pictures, then shapes. */
export const drawn = computed(() => {
  const order = ["depths", "picture", "features"];
  return [...got.value.values()]
    .filter(({ shown }) => !hidden.value.includes(shown.name))
    .sort((a, b) => order.indexOf(a.shown.kind) - order.indexOf(b.shown.kind));
});

/** The depth grid that is drawn: the mission's own where it names one. */
export const depths = computed(() => {
  const grids = drawn.value.filter(({ shown }) => shown.depths);
  return (grids.find(({ shown }) => shown.name === floorChart.value) ?? grids[0])?.shown;
});

export function setHidden(name: string, off: boolean): void {
  hidden.value = off ? [...hidden.peek(), name] : hidden.peek().filter((one) => one !== name);
  try {
    localStorage.setItem(KEY, JSON.stringify(hidden.peek()));
  } catch {
    // Without storage the choice lasts as long as the page.
  }
}

const place = computed(() => JSON.stringify(originOf(mission.value.raw) ?? null));
let turn = 0;

/** Ask for what is looked at whenever the list or the mission's place on the earth changes. */
export function followCharts(): () => void {
  void charts.refresh();
  return effect(() => {
    const list = chartsHere.value;
    const origin = JSON.parse(place.value) as ReturnType<typeof originOf> | null;
    if (list) untracked(() => void load(list, origin ?? undefined));
  });
}

async function load(list: readonly ChartSummary[], origin: ReturnType<typeof originOf>): Promise<void> {
  const mine = ++turn;
  const query = origin
    ? { latitude_deg: origin.latitude, longitude_deg: origin.longitude, heading_deg: origin.heading }
    : {};
  const wanted = list.filter(({ geographic }) => !geographic || origin);
  const answers = await Promise.all(
    wanted.map(({ name }) => ask("get", "/api/charts/{name}/shown", { path: { name }, query })),
  );
  if (mine !== turn) return;
  got.value = new Map(
    answers.flatMap((answer) =>
      answer.ok ? [[answer.value.name, { shown: answer.value, picture: undefined }] as const] : [],
    ),
  );
  for (const answer of answers) if (answer.ok && answer.value.kind === "picture") fetchPicture(answer.value);
}

function fetchPicture(shown: ChartShown): void {
  const picture = new Image();
  picture.onload = () => {
    if (got.peek().get(shown.name)?.shown !== shown) return; // another origin since
    got.value = new Map(got.peek()).set(shown.name, { shown, picture });
  };
  picture.src = address("/api/charts/{name}/picture", { name: shown.name });
}

export interface Given {
  file: File;
  corners?: string;
  local: boolean;
}

/** Keep a file as a chart of the site. */
export async function addChart({ file, corners, local }: Given): Promise<boolean> {
  const name = file.name
    .replace(/[^A-Za-z0-9._-]+/g, "_")
    .replace(/^[^A-Za-z0-9]+/, "")
    .slice(0, 64);
  const query = { file_name: file.name, ...(corners ? { corners } : {}), ...(local ? { local } : {}) };
  const answer = await ask("put", "/api/charts/{name}", {
    path: { name: name || "chart" },
    query,
    body: file as never,
  });
  chartTrouble.value = answer.ok ? undefined : answer;
  await charts.refresh();
  return answer.ok;
}

/** Give a chart to this mission alone, or to the site again. */
export async function ownChart(name: string, missions: string[]): Promise<void> {
  const answer = await ask("put", "/api/charts/{name}/owners", { path: { name }, body: { missions } });
  chartTrouble.value = answer.ok ? undefined : answer;
  await charts.refresh();
}

export async function removeChart(name: string): Promise<void> {
  const answer = await ask("delete", "/api/charts/{name}", { path: { name } });
  chartTrouble.value = answer.ok ? undefined : answer;
  await charts.refresh();
}
