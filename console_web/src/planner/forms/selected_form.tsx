// The form of what is selected; of the mission as a whole when nothing is.

import { fixed } from "../../lib/format";
import { short } from "../model/document";
import { along, bearing, legFacts } from "../model/geometry";
import { dockEdits, setCurrent, splitLeg } from "../model/operations";
import { edit, mission, selected } from "../model/plan";
import { eventOf, legOf, outlineAt } from "../model/things";
import { EarthPlace } from "./earth_place";
import { FormPart } from "./form";
import { NumberInput } from "./number_input";
import { Remove } from "./remove";
import { EventForm, OutlineForm, WaveForm } from "./thing_forms";

const ELSEWHERE = ["version", "name", "start", "legs", "target"];

export function SelectedForm() {
  const things = selected.value;
  const [thing] = things;
  if (things.length > 1) return <Several count={things.length} />;
  if (thing === "start") return <StartForm />;
  if (thing === "dock" && mission.value.dock) return <DockForm />;
  if (thing === "current") return <CurrentForm />;
  if (thing === "wave") return <WaveForm />;
  const which = thing === undefined ? undefined : outlineAt(thing);
  if (thing !== undefined && which !== undefined)
    return <OutlineForm key={which} which={which} thing={thing} />;
  const event = thing === undefined ? undefined : eventOf(thing);
  if (event) return <EventForm key={thing} kind={event.kind} index={event.index} />;
  const leg = thing === undefined ? undefined : legOf(thing);
  if (leg !== undefined && mission.value.legs[leg]) return <LegForm key={leg} index={leg} />;
  return (
    <div class="form">
      <h3 class="form-title">Mission</h3>
      <FormPart path={[]} without={ELSEWHERE} />
    </div>
  );
}

function Several({ count }: { count: number }) {
  return (
    <div class="form">
      <h3 class="form-title">{count} things selected</h3>
      <p class="hint">Drag one or use the arrows to move them all; copy, cut and paste work as in a text.</p>
      <Remove what="them" />
    </div>
  );
}

function StartForm() {
  return (
    <div class="form">
      <h3 class="form-title">Start</h3>
      <FormPart path={["start"]} />
      <EarthPlace thing="start" />
    </div>
  );
}

function LegForm({ index }: { index: number }) {
  const view = mission.value;
  const facts = legFacts(view.start.at, view.legs)[index];
  return (
    <div class="form">
      <h3 class="form-title">Waypoint {index + 1}</h3>
      <FormPart path={["legs", index]} />
      <EarthPlace thing={`leg:${index}`} />
      {facts && (
        <p class="hint num">
          {fixed(facts.length, 1)} m on {fixed(facts.heading, 0)}°, {fixed(facts.seconds, 0)} s
        </p>
      )}
      <div class="form-head">
        <button type="button" class="action small" onClick={() => splitLeg(index)}>
          Waypoint before
        </button>
        <Remove what="waypoint" />
      </div>
    </div>
  );
}

function DockForm() {
  const view = mission.value;
  const { dock } = view;
  if (!dock) return null;
  const change = (part: { heading?: number; standoff?: number }, key: string): void =>
    edit(`Change the ${key}`, dockEdits(mission.peek(), part), `dock ${key}`);
  return (
    <div class="form">
      <h3 class="form-title">Dock</h3>
      <FormPart path={["target"]} only={["position_ned_m"]} />
      <EarthPlace thing="dock" />
      <div class="field-row">
        <span class="field-label">Heading to approach with, from north over east</span>
        <NumberInput
          name="Approach heading"
          unit="deg"
          title="The last leg follows"
          value={dock.heading}
          refuse={(value) => (value < -360 || value > 360 ? "must be from -360 to 360" : "")}
          onGive={(value) => value !== undefined && change({ heading: value }, "heading")}
        />
      </div>
      <div class="field-row">
        <span class="field-label">Standoff: observation point before the dock</span>
        <NumberInput
          name="Standoff"
          unit="m"
          title="The last leg follows"
          value={dock.standoff}
          refuse={(value) => (value < 0 || value > 100 ? "must be from 0 to 100" : "")}
          onGive={(value) => value !== undefined && change({ standoff: value }, "standoff")}
        />
      </div>
      <FormPart path={["target"]} without={["position_ned_m", "heading_deg", "standoff_m"]} />
      <Remove what="dock" />
    </div>
  );
}

function CurrentForm() {
  const view = mission.value;
  const [north, east, down] = view.current;
  const speed = short(Math.hypot(north, east));
  const way = speed > 0 ? short(bearing([0, 0, 0], view.current), 1) : 0;
  const set = (metres: number, degrees: number): void =>
    edit(
      "Change the current",
      setCurrent(mission.peek(), along([0, 0, down], degrees, metres)),
      "current form",
    );
  return (
    <div class="form">
      <h3 class="form-title">Current and sea</h3>
      <div class="field-row">
        <span class="field-label">Speed of the current</span>
        <NumberInput
          name="Speed of the current"
          unit="m/s"
          title="0 to 5 m/s"
          value={speed}
          refuse={(value) => (value < 0 || value > 5 ? "must be from 0 to 5" : "")}
          onGive={(value) => value !== undefined && set(value, way)}
        />
      </div>
      <div class="field-row">
        <span class="field-label">Flows towards</span>
        <NumberInput
          name="Direction of the current"
          unit="deg"
          title="From north over east, the way it flows"
          value={way}
          refuse={(value) => (value < -360 || value > 360 ? "must be from -360 to 360" : "")}
          onGive={(value) => value !== undefined && set(speed || 0.05, value)}
        />
      </div>
      <FormPart path={["environment"]} />
      {speed > 0 && <Remove what="current" />}
    </div>
  );
}
