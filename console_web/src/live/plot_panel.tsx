// The plots: one group at a time, all on the same time window and cursor.
import { useSignal } from "@preact/signals";
import "uplot/dist/uPlot.min.css";
import { screen } from "../stream/screen";
import { Empty, Panel } from "../ui/panel";
import { Segments } from "../ui/segments";
import { Plot } from "./plot";
import { GROUPS, type Group, specsOf } from "./plots";
import "./plot_panel.css";

const CHOICES = GROUPS.map((name) => ({ value: name, name }));

export function PlotPanel() {
  const group = useSignal<Group>("Motion");
  const choice = (
    <Segments
      name="Plot group"
      choices={CHOICES}
      chosen={group.value}
      onChoose={(next) => {
        group.value = next;
      }}
    />
  );
  return (
    <Panel title="Plots" topic="tlm/navigation" class="plot-panel" aside={choice}>
      <Plots group={group.value} />
    </Panel>
  );
}

function Plots({ group }: { group: Group }) {
  if (!screen.latest("tlm/navigation")) return <Empty>Plots begin with the first telemetry.</Empty>;
  const specs = specsOf(group);
  return (
    <div class="plots" data-many={specs.length > 4 ? "yes" : undefined}>
      {specs.map((spec, index) => (
        <Plot key={spec.id} spec={spec} axis={index === specs.length - 1 || specs.length > 4} />
      ))}
    </div>
  );
}
