// Each actuator inside its amplitude bounds, with the window that this cycle's increment allows.
// Saturation and rate limit have a shape of their own beside the colour.
import type { Actuator } from "../gen/bumpless_pb";
import { fixed } from "../lib/format";
import { screen } from "../stream/screen";
import { DiamondIcon, TriangleIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import { Term } from "../words/term";
import "./actuator_panel.css";

export function ActuatorPanel() {
  return (
    <Panel title="Actuators" topic="tlm/actuators" class="actuator-panel" aside={<Legend />}>
      <Rows />
    </Panel>
  );
}

function Legend() {
  return (
    <span class="legend">
      <span class="flag" data-look="saturated">
        <TriangleIcon size={9} /> <Term of="at_bound">at bound</Term>
      </span>
      <span class="flag" data-look="limited">
        <DiamondIcon size={9} /> <Term of="rate_limited">rate-limited</Term>
      </span>
    </span>
  );
}

function Rows() {
  const actuators = screen.latest("tlm/actuators")?.actuators ?? [];
  if (!actuators.length) return <Empty>Actuators appear with the first telemetry.</Empty>;
  return (
    <ul class="actuators">
      {actuators.map((actuator) => (
        <Row key={actuator.name} actuator={actuator} />
      ))}
    </ul>
  );
}

function Row({ actuator: a }: { actuator: Actuator }) {
  const whole = a.amplitudeUpper - a.amplitudeLower || 1;
  const at = (value: number): number =>
    Math.max(0, Math.min(100, (100 * (value - a.amplitudeLower)) / whole));
  const unit = a.unit === "deg" ? "°" : a.unit;
  const decimals = a.unit === "deg" ? 1 : 0;
  const state = a.saturated ? "saturated" : a.rateLimited ? "limited" : "free";
  const window = { left: `${at(a.lower)}%`, width: `${Math.max(0.5, at(a.upper) - at(a.lower))}%` };
  const about =
    `${a.name}: command ${fixed(a.command, decimals)}, feedback ${fixed(a.feedback, decimals)} ${unit}; ` +
    `bounds ${fixed(a.amplitudeLower, decimals)} to ${fixed(a.amplitudeUpper, decimals)}, ` +
    `now ${fixed(a.lower, decimals + 1)} to ${fixed(a.upper, decimals + 1)}`;
  const share = a.effectiveness !== undefined && a.effectiveness < 0.995 ? a.effectiveness : undefined;
  return (
    <li
      class="actuator"
      data-state={state}
      title={share === undefined ? about : `${about}; effectiveness ${fixed(share, 2)}`}
    >
      <span class="actuator-name">
        {a.name}
        {share !== undefined && <span class="actuator-share num">{fixed(100 * share, 0)} %</span>}
      </span>
      <span class="travel">
        <i class="travel-window" style={window} />
        <i class="travel-zero" style={{ left: `${at(0)}%` }} />
        <i
          class="travel-feedback"
          style={{
            left: `${Math.min(at(0), at(a.feedback))}%`,
            width: `${Math.abs(at(a.feedback) - at(0))}%`,
          }}
        />
        <i class="travel-command" style={{ left: `${at(a.command)}%` }} />
      </span>
      <span class="num actuator-value">
        {fixed(a.command, decimals)}
        <span class="unit"> {unit}</span>
      </span>
      <span class="flag" data-look={state}>
        {a.saturated && (
          <>
            <TriangleIcon size={10} />
            <span class="sr">at its bound</span>
          </>
        )}
        {!a.saturated && a.rateLimited && (
          <>
            <DiamondIcon size={10} />
            <span class="sr">rate-limited</span>
          </>
        )}
      </span>
    </li>
  );
}
