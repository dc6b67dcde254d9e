// Demanded against achieved generalised force, component by component, on bars from zero.
import { signed } from "../lib/format";
import { controllableAxes } from "../lib/vehicle";
import { axisUnit, type WrenchAxis, wrenchOf } from "../lib/wrench";
import { inForce, screen } from "../stream/screen";
import { Empty, Panel } from "../ui/panel";
import "./wrench_panel.css";

/** Full scale of each bar: grows with what has been seen, in steps, so that bars keep still. */
const scales = new Map<WrenchAxis, number>();

function scaleFor(axis: WrenchAxis, ...values: (number | null)[]): number {
  const largest = Math.max(...values.map((value) => Math.abs(value ?? 0)));
  let scale = scales.get(axis) ?? 0.1;
  for (const step of [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000]) {
    if (scale >= largest) break;
    scale = Math.max(scale, step);
  }
  scales.set(axis, scale);
  return scale;
}

export function WrenchPanel() {
  return (
    <Panel title="Wrench" topic="tlm/control" unit="body axes" class="wrench-panel" aside={<Legend />}>
      <Rows />
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
            dem.
          </th>
          <th scope="col" class="num">
            ach.
          </th>
          <th scope="col" class="num">
            resid.
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
                {axis} <span class="unit">{axisUnit(axis)}</span>
              </th>
              <td class="bar-cell">
                <Bar demanded={demanded} achieved={achieved} scale={scale} />
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
  demanded,
  achieved,
  scale,
}: {
  demanded: number | null;
  achieved: number | null;
  scale: number;
}) {
  const at = (value: number): number => 50 + 50 * Math.max(-1, Math.min(1, value / scale));
  const end = at(achieved ?? 0);
  return (
    <span class="bar" title={`Full scale ±${scale}`}>
      <i class="bar-zero" />
      <i class="bar-fill" style={{ left: `${Math.min(50, end)}%`, width: `${Math.abs(end - 50)}%` }} />
      {demanded !== null && <i class="bar-tick" style={{ left: `${at(demanded)}%` }} />}
    </span>
  );
}
