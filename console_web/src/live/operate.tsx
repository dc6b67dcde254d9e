// Four questions of who operates: where is it, what is it doing, does it follow, what is left.
import { useEffect } from "preact/hooks";
import { fixed, headingOf, signed } from "../lib/format";
import { TrackMap } from "../replay/track_map";
import { inForce, screen } from "../stream/screen";
import { TriangleIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import { AttainableSets } from "./attainable";
import { trackingErrors } from "./errors";
import { EventPanel } from "./event_panel";
import { ModePanel } from "./mode_panel";
import "./operate.css";
import { PlotPanel } from "./plot_panel";
import { watchReach } from "./reach";

export function Operate() {
  useEffect(watchReach, []);
  return (
    <div class="operate">
      <section class="question" aria-label="Where is it?">
        <h2>Where is it?</h2>
        <Where />
        <TrackMap />
      </section>
      <section class="question" aria-label="What is it doing?">
        <h2>What is it doing?</h2>
        <ModePanel />
        <EventPanel />
      </section>
      <section class="question" aria-label="Does it follow?">
        <h2>Does it follow?</h2>
        <div class="follows">
          <Following />
          <PlotPanel />
        </div>
      </section>
      <section class="question" aria-label="What is left?">
        <h2>What is left?</h2>
        <Left />
      </section>
    </div>
  );
}

function Where() {
  const nav = screen.latest("tlm/navigation");
  if (!nav) return <Empty>The vehicle's estimate appears with the first telemetry.</Empty>;
  const facts: [string, string, string][] = [
    ["Depth", fixed(nav.depthM, 1), "m"],
    ["Heading", headingOf(nav.attitude?.yawDeg, 0), "°"],
    ["Speed", fixed(nav.speedOverGroundMps, 2), "m/s"],
    ["To go", fixed(inForce.value ? screen.latest("tlm/supervisor")?.rangeM : NaN, 1), "m"],
  ];
  return (
    <dl class="large" data-state={screen.isFresh("tlm/navigation") ? "fresh" : "stale"}>
      {facts.map(([name, value, unit]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>
            <b class="num">{value}</b> <span class="unit">{unit}</span>
          </dd>
        </div>
      ))}
    </dl>
  );
}

function Following() {
  const errors = trackingErrors();
  return (
    <Panel title="Errors" topic="tlm/guidance" unit="the bar ends at the alarm's limit">
      {errors.every(({ error }) => !Number.isFinite(error)) ? (
        <Empty>Nothing is followed: no control is in force.</Empty>
      ) : (
        <ul class="errors">
          {errors.map(({ name, unit, decimals, error, limit }) => {
            const share = Math.abs(error) / limit;
            return (
              <li key={name} data-look={share >= 1 ? "alarm" : share >= 0.7 ? "warning" : "good"}>
                <span>{name}</span>
                <span class="meter">
                  <i style={{ width: `${100 * Math.min(1, share || 0)}%` }} />
                </span>
                <b class="num">
                  {signed(error, decimals)} <span class="unit">{unit}</span>
                </b>
                <span class="muted num">of {fixed(limit, decimals)}</span>
              </li>
            );
          })}
        </ul>
      )}
    </Panel>
  );
}

function Left() {
  const used = (screen.latest("tlm/actuators")?.actuators ?? []).filter(({ saturated }) => saturated);
  return (
    <Panel title="Margin" topic="tlm/control">
      <AttainableSets />
      <p class="at-bound">
        {used.length ? (
          <>
            <TriangleIcon size={11} /> At a bound: <b>{used.map(({ name }) => name).join(", ")}</b>
          </>
        ) : (
          "No actuator is at its bound."
        )}
      </p>
    </Panel>
  );
}
