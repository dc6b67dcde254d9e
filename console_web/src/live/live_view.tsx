// The live view: scene and mode at the left, plots in the middle, forces and actuators at the right.
// Only the scene stays in the page while another view is shown.
import { replay } from "../replay/current";
import { ReplayScene } from "../replay/replay_scene";
import { TrackMap } from "../replay/track_map";
import { Main } from "../ui/main";
import { ActuatorPanel } from "./actuator_panel";
import { AllocationPanel } from "./allocation_panel";
import { EventPanel } from "./event_panel";
import "./live_view.css";
import { ModePanel } from "./mode_panel";
import { PlotPanel } from "./plot_panel";
import { Scene } from "./scene";
import { StatePanel } from "./state_panel";
import { WrenchPanel } from "./wrench_panel";

export function LiveView({ hidden }: { hidden: boolean }) {
  const run = hidden ? undefined : replay.value;
  return (
    <Main name={run ? "Replay" : "Live view"} class="live" hidden={hidden}>
      <div class="live-left">
        <Scene hidden={run !== undefined} />
        {run && <ReplayScene key={run.run} replay={run} />}
        {run && <TrackMap />}
        {!hidden && <ModePanel />}
      </div>
      {!hidden && (
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
      )}
    </Main>
  );
}
