// The plots: one group at a time, all on the same time window and cursor.
import { useState } from "preact/hooks";
import { useFrame } from "../stream/frame";
import { live } from "../stream/store";
import { Empty, Panel } from "../ui/panel";
import { Plot } from "./plot";
import { GROUPS, specsOf, type Group } from "./plots";
import { setWindow, window_s, WINDOWS_S } from "./time_axis";

export function PlotPanel() {
  const [group, setGroup] = useState<Group>("Motion");
  return (
    <Panel
      title="Plots"
      topic="tlm/navigation"
      class="plot-panel"
      aside={
        <>
          <div class="segments" role="group" aria-label="Plot group">
            {GROUPS.map((name) => (
              <button key={name} type="button" aria-pressed={group === name} onClick={() => setGroup(name)}>
                {name}
              </button>
            ))}
          </div>
          <WindowChoice />
        </>
      }
    >
      <Plots group={group} />
    </Panel>
  );
}

function WindowChoice() {
  useFrame();
  return (
    <select
      class="small"
      aria-label="Time window of plots and mode strip"
      value={window_s()}
      onChange={(event) => setWindow(Number(event.currentTarget.value))}
    >
      {WINDOWS_S.map((seconds) => (
        <option key={seconds} value={seconds}>{seconds < 120 ? `${seconds} s` : `${seconds / 60} min`}</option>
      ))}
    </select>
  );
}

function Plots({ group }: { group: Group }) {
  useFrame();
  if (!live.latest("tlm/navigation")) return <Empty>Plots begin with the first telemetry.</Empty>;
  const specs = specsOf(group);
  return (
    <div class="plots" data-many={specs.length > 4 ? "yes" : undefined}>
      {specs.map((spec, index) => (
        <Plot key={spec.id} spec={spec} axis={index === specs.length - 1 || specs.length > 4} />
      ))}
    </div>
  );
}
