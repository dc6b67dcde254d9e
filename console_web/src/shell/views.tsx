// The views by the server's table, each loaded when it is first opened. To add one: a line in the server's
// table, a line here, and its component.
import { computed, effect, signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { runs } from "../api/resources";
import { VIEWS } from "../gen/house";
import { replayed } from "../replay/current";
import { Main } from "../ui/main";
import { Empty, Panel } from "../ui/panel";
import { address } from "./address";

export type ViewId = (typeof VIEWS)[number]["id"];
type View = ComponentType<{ hidden: boolean }>;

const LOADERS: Record<ViewId, () => Promise<View>> = {
  live: async () => (await import("../live/live_view")).LiveView,
  plan: async () => (await import("../planner/planner_view")).PlannerView,
  missions: async () => (await import("../missions/missions_view")).MissionsView,
  weights: async () => (await import("../weights/weights_view")).WeightsView,
  runs: async () => (await import("../runs/runs_view")).RunsView,
  system: async () => (await import("../system/system_view")).SystemView,
};
/** Stays in the page while another view is shown: its scene is slow to load. */
const KEPT: ViewId = "live";

const loaded = signal<Partial<Record<ViewId, View>>>({});
const failed = signal<ViewId | undefined>(undefined);

/** The view that the address names. */
export const view = computed<ViewId>(() => VIEWS.find(({ id }) => id === address.value.view)?.id ?? "live");
/** The one that shows it: a run is seen again in the Live view. */
const shown = computed<ViewId>(() => (replayed.value ? "live" : view.value));

async function load(id: ViewId): Promise<void> {
  if (loaded.peek()[id]) return;
  try {
    const component = await LOADERS[id]();
    loaded.value = { ...loaded.peek(), [id]: component };
    failed.value = undefined;
  } catch {
    failed.value = id; // the server is away
  }
}

effect(() => void load(shown.value));

effect(() => {
  const name = replayed.value ? "Replay" : VIEWS.find(({ id }) => id === view.value)?.name;
  const { id, query } = address.value;
  const called = view.value === "runs" && id && runs.value?.find((run) => run.id === id)?.title;
  const what = query.compare === undefined ? name : "Comparison";
  document.title = `${what}${id && ` of ${called || id}`} · Bumpless`;
});

export function Views() {
  const here = shown.value;
  const open = VIEWS.filter(({ id }) => id === here || id === KEPT);
  return (
    <>
      {open.map(({ id, name }) => {
        const Component = loaded.value[id];
        if (Component) return <Component key={id} hidden={id !== here} />;
        return id === here && <Unloaded key={id} id={id} name={name} />;
      })}
    </>
  );
}

function Unloaded({ id, name }: { id: ViewId; name: string }) {
  return (
    <Main name={name} class="view">
      {failed.value === id && (
        <Panel title={name}>
          <Empty>
            This view could not be loaded: the server does not answer.{" "}
            <button type="button" class="action small" onClick={() => void load(id)}>
              Try again
            </button>
          </Empty>
        </Panel>
      )}
    </Main>
  );
}
