// The plots: one group at a time, all on the same time window and cursor.
import { useState } from "preact/hooks";
import { useFrame } from "../stream/frame";
import { live } from "../stream/store";
import { Empty, Panel } from "../ui/panel";
import { Plot } from "./plot";
import { GROUPS, specsOf, type Group } from "./plots";

export function PlotPanel() {
  const [group, setGroup] = useState<Group>("Motion");
  return (
    <Panel
      title="Plots"
      topic="tlm/navigation"
      class="plot-panel"
      aside={
        <div class="segments" role="group" aria-label="Plot group">
          {GROUPS.map((name) => (
            <button key={name} type="button" aria-pressed={group === name} onClick={() => setGroup(name)}>
              {name}
            </button>
          ))}
        </div>
      }
    >
      <Plots group={group} />
    </Panel>
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
