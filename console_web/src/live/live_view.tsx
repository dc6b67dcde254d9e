// The live view in one of its arrangements. Engineer: scene and mode at the left, plots in the middle, forces
// and actuators at the right. Only the scene stays in the page while something else is shown.
import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { replay } from "../replay/current";
import { ReplayScene } from "../replay/replay_scene";
import { TrackMap } from "../replay/track_map";
import { screen } from "../stream/screen";
import { Main } from "../ui/main";
import { Empty } from "../ui/panel";
import { ActuatorPanel } from "./actuator_panel";
import { AllocationPanel } from "./allocation_panel";
import { ARRANGEMENTS, type Arrangement, arrangement } from "./arrangement";
import { EventPanel } from "./event_panel";
import { FirstSteps } from "./first_steps";
import "./live_view.css";
import { ModePanel } from "./mode_panel";
import { PlotPanel } from "./plot_panel";
import { Scene } from "./scene";
import { StatePanel } from "./state_panel";
import { WrenchPanel } from "./wrench_panel";

const LOADERS: Record<Exclude<Arrangement, "engineer">, () => Promise<ComponentType>> = {
  operate: async () => (await import("./operate")).Operate,
  wall: async () => (await import("./wall")).Wall,
};
const loaded = signal<Partial<Record<Arrangement, ComponentType>>>({});
const failed = signal(false);

async function load(which: Exclude<Arrangement, "engineer">): Promise<void> {
  try {
    const component = await LOADERS[which]();
    loaded.value = { ...loaded.peek(), [which]: component };
    failed.value = false;
  } catch {
    failed.value = true; // the server is away
  }
}

export function LiveView({ hidden }: { hidden: boolean }) {
  const run = hidden ? undefined : replay.value;
  const as = arrangement.value;
  const whole = as === "engineer";
  const words = ARRANGEMENTS.find(({ value }) => value === as)?.name;
  return (
    <Main
      name={run ? "Replay" : whole ? "Live view" : `Live view, ${words}`}
      class="live"
      hidden={hidden}
      state={as}
    >
      {!hidden && screen.isLive && <FirstSteps />}
      <div class="live-left" hidden={!whole}>
        <Scene hidden={run !== undefined} />
        {run && whole && <ReplayScene key={run.run} replay={run} />}
        {run && whole && <TrackMap />}
        {!hidden && whole && <ModePanel />}
      </div>
      {!hidden && (whole ? <Engineer /> : <Other which={as} />)}
    </Main>
  );
}

function Engineer() {
  return (
    <>
      <div class="live-middle">
        <PlotPanel />
        <StatePanel />
      </div>
      <div class="live-right">
        <WrenchPanel />
        <ActuatorPanel />
        <AllocationPanel />
        <EventPanel />
      </div>
    </>
  );
}

function Other({ which }: { which: Exclude<Arrangement, "engineer"> }) {
  const Component = loaded.value[which];
  useEffect(() => {
    if (!Component) void load(which);
  }, [which]);
  if (Component) return <Component />;
  if (!failed.value) return null;
  return (
    <Empty>
      This arrangement could not be loaded: the server does not answer.{" "}
      <button type="button" class="action small" onClick={() => void load(which)}>
        Try again
      </button>
    </Empty>
  );
}
