// Demanded against achieved generalised force, component by component, on bars from zero.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { signed } from "../lib/format";
import { controllableAxes } from "../lib/vehicle";
import { axisUnit, WRENCH_AXES, type WrenchAxis, wrenchOf } from "../lib/wrench";
import { inForce, screen } from "../stream/screen";
import { Empty, Panel } from "../ui/panel";
import { Segments } from "../ui/segments";
import { Term } from "../words/term";
import { AttainableSets } from "./attainable";
import { reach, reachOf, watchReach } from "./reach";
import "./wrench_panel.css";

/** Full scale of each bar where the attainable sets are not known: grows with what has been seen, in steps. */
const seen = new Map<WrenchAxis, number>();
const STEPS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000];
const VIEWS = [
  { value: "bars", name: "Bars", about: "Each component from zero, with the attainable bounds" },
  { value: "sets", name: "Sets", about: "Cuts of the attainable sets, with demand and answer inside" },
] as const;

const stepOver = (value: number): number => STEPS.find((step) => step >= value) ?? value;

/** By what the vehicle can do at any speed: it holds still. A demand beyond it ends at the bar's end. */
function scaleFor(axis: WrenchAxis, ...values: (number | null)[]): number {
  const most = reachOf(axis);
  if (most > 0) return stepOver(most);
  const largest = Math.max(seen.get(axis) ?? 0.1, ...values.map((value) => Math.abs(value ?? 0)));
  seen.set(axis, stepOver(largest));
  return stepOver(largest);
}

export function WrenchPanel() {
  const shown = useSignal<"bars" | "sets">("bars");
  useEffect(watchReach, []);
  const aside = (
    <>
      {shown.value === "bars" && <Legend />}
      <Segments
        name="Wrench as"
        choices={VIEWS}
        chosen={shown.value}
        onChoose={(next) => {
          shown.value = next;
        }}
      />
    </>
  );
  return (
    <Panel title="Wrench" topic="tlm/control" class="wrench-panel" aside={aside}>
      {shown.value === "bars" ? <Rows /> : <AttainableSets />}
    </Panel>
  );
}

function Legend() {
  return (
    <span class="legend muted">
      <span>
        <i class="key-achieved" /> achieved
      </span>
      <span>
        <i class="key-demanded" /> demanded
      </span>
    </span>
  );
}

function Rows() {
  const control = screen.latest("tlm/control");
  if (control && !inForce.value) return <Empty>No wrench is demanded: no control is in force.</Empty>;
  if (!control) return <Empty>Demanded and achieved wrench appear with the first telemetry.</Empty>;
  return (
    <table class="wrench">
      <thead>
        <tr>
          <th scope="col">
            <span class="sr">Component</span>
          </th>
          <th scope="col">
            <span class="sr">Achieved as a bar, demanded as a mark</span>
          </th>
          <th scope="col" class="num">
            <Term of="demanded">dem.</Term>
          </th>
          <th scope="col" class="num">
            <Term of="achieved">ach.</Term>
          </th>
          <th scope="col" class="num">
            <Term of="residual">resid.</Term>
          </th>
        </tr>
      </thead>
      <tbody>
        {controllableAxes().map((axis) => {
          const demanded = wrenchOf(control.demanded, axis);
          const achieved = wrenchOf(control.achieved, axis);
          const scale = scaleFor(axis, demanded, achieved);
          const residual = wrenchOf(control.residual, axis);
          const missed = Math.abs(residual ?? 0) > Math.max(0.1 * Math.abs(demanded ?? 0), 0.05 * scale);
          return (
            <tr key={axis} data-missed={missed ? "yes" : undefined}>
              <th scope="row">
                <Term of={axis}>{axis}</Term> <span class="unit">{axisUnit(axis)}</span>
              </th>
              <td class="bar-cell">
                <Bar axis={axis} demanded={demanded} achieved={achieved} scale={scale} />
              </td>
              <td class="num" data-testid={`demanded-${axis}`}>
                {signed(demanded, 2)}
              </td>
              <td class="num">{signed(achieved, 2)}</td>
              <td class="num residual">{signed(residual, 2)}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

function Bar({
  axis,
  demanded,
  achieved,
  scale,
}: {
  axis: WrenchAxis;
  demanded: number | null;
  achieved: number | null;
  scale: number;
}) {
  const at = (value: number): number => 50 + 50 * Math.max(-1, Math.min(1, value / scale));
  const end = at(achieved ?? 0);
  const index = WRENCH_AXES.indexOf(axis);
  const [low, high] = [reach.value?.low[index], reach.value?.high[index]];
  const bounds = low !== undefined && high !== undefined;
  const about = bounds ? `; attainable at this speed ${signed(low, 2)} to ${signed(high, 2)}` : "";
  return (
    <span class="bar" title={`Full scale ±${scale}${about}`}>
      {bounds && <i class="bar-beyond" style={{ left: 0, width: `${at(low)}%` }} />}
      {bounds && <i class="bar-beyond" style={{ left: `${at(high)}%`, right: 0 }} />}
      <i class="bar-zero" />
      <i class="bar-fill" style={{ left: `${Math.min(50, end)}%`, width: `${Math.abs(end - 50)}%` }} />
      {demanded !== null && <i class="bar-tick" style={{ left: `${at(demanded)}%` }} />}
    </span>
  );
}
