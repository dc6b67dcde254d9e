// Forms of what is neither way nor dock: zones, the boundary, waves, faults and outages.
import type { EventKind } from "../model/event_kinds";
import { selected } from "../model/plan";
import {
  cornerOf,
  cornersPath,
  cornerThing,
  EVENT_PATHS,
  outlineThing,
  type Thing,
  type Which,
} from "../model/things";
import { EarthPlace } from "./earth_place";
import { FormPart } from "./form";
import { Remove } from "./remove";

export function OutlineForm({ which, thing }: { which: Which; thing: Thing }) {
  const corner = cornerOf(thing);
  const title = which === "in" ? "Keep-in boundary" : `Keep-out zone ${which + 1}`;
  if (corner)
    return (
      <div class="form">
        <h3 class="form-title">
          {title}, corner {corner.index + 1}
        </h3>
        <FormPart path={[...cornersPath(which), corner.index]} />
        <EarthPlace thing={thing} />
        <div class="form-head">
          <button
            type="button"
            class="action small"
            onClick={() => {
              selected.value = [outlineThing(which)];
            }}
          >
            The whole outline
          </button>
          <Remove what="corner" />
        </div>
      </div>
    );
  return (
    <div class="form">
      <h3 class="form-title">{title}</h3>
      {which !== "in" && <FormPart path={["keep_out", which]} without={["corners"]} />}
      <FormPart path={cornersPath(which).slice(0, -1)} only={["corners"]} />
      <div class="form-head">
        <button
          type="button"
          class="action small"
          title="Brackets go on from corner to corner"
          onClick={() => {
            selected.value = [cornerThing(which, 0)];
          }}
        >
          First corner
        </button>
        <Remove what={which === "in" ? "boundary" : "zone"} />
      </div>
    </div>
  );
}

export function WaveForm() {
  return (
    <div class="form">
      <h3 class="form-title">Waves</h3>
      <FormPart path={["environment", "wave"]} />
      <Remove what="waves" />
    </div>
  );
}

const EVENT_NAMES: Record<EventKind, string> = {
  fault: "Fault of an actuator",
  outage: "Outage of sight",
  dvl: "Outage of the Doppler log",
};

export function EventForm({ kind, index }: { kind: EventKind; index: number }) {
  return (
    <div class="form">
      <h3 class="form-title">{EVENT_NAMES[kind]}</h3>
      <FormPart path={[...EVENT_PATHS[kind], index]} />
      <Remove what={kind === "fault" ? "fault" : "outage"} />
    </div>
  );
}
