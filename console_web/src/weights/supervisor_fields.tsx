// When modes switch, how detection is filtered, and which bumpless mechanisms act.
import { NumberField, SwitchField } from "./field";
import { otherNumbers } from "./ranges";
import "./supervisor_fields.css";

interface Entry {
  key: string;
  name: string;
  about: string;
  unit: string;
  integer?: boolean;
}

const RANGES: Entry[] = [
  { key: "range_rh_lower_m", name: "R → H at or below", about: "d_RH^L", unit: "m" },
  { key: "range_rh_upper_m", name: "H → R at or above", about: "d_RH^U", unit: "m" },
  { key: "range_fr_lower_m", name: "F → R at or below", about: "d_FR^L", unit: "m" },
  { key: "range_fr_upper_m", name: "R → F at or above", about: "d_FR^U", unit: "m" },
  { key: "range_hf_upper_m", name: "H → F at or above", about: "d_HF^U", unit: "m" },
];
const COUNTS: Entry[] = [
  { key: "dwell_cycles", name: "Shortest stay in a mode", about: "N_dwell", unit: "cycles", integer: true },
  { key: "detection_hits", name: "Detections needed", about: "M", unit: "frames", integer: true },
  {
    key: "detection_window",
    name: "Out of the last",
    about: "N; 1 of 1 switches the filter off",
    unit: "frames",
    integer: true,
  },
  {
    key: "detection_hold_cycles",
    name: "Detection held for",
    about: "after the last hit",
    unit: "frames",
    integer: true,
  },
];

/** "d_RH^L" with its index low and its bound high. */
function Letters({ text }: { text: string }) {
  const match = /^([A-Za-z])_(\w+?)(?:\^(\w))?$/.exec(text);
  if (!match) return <>{text}</>;
  return (
    <>
      <i>{match[1]}</i>
      <sub>{match[2]}</sub>
      {match[3] && <sup>{match[3]}</sup>}
    </>
  );
}

function Entries({ entries }: { entries: Entry[] }) {
  return (
    <div class="entries">
      {entries.map(({ key, name, about, unit, integer }) => (
        <div key={key} class="entry">
          <span class="entry-name">
            {name}{" "}
            <span class="muted">
              <Letters text={about} />
            </span>
          </span>
          <NumberField
            path={`supervisor.${key}`}
            name={about ? `${name} (${about})` : name}
            integer={integer}
          />
          <span class="unit">{unit}</span>
        </div>
      ))}
    </div>
  );
}

/** What is declared and has no line above. */
function others(): Entry[] {
  const named = [...RANGES, ...COUNTS].map(({ key }) => key);
  return otherNumbers("supervisor", named).map(({ path, label, unit }) => {
    return { key: path.split(".")[1] as string, name: label, about: "", unit: unit === "1" ? "" : unit };
  });
}

export function SupervisorFields() {
  return (
    <>
      <p class="hint">Ranges to the observation point; they must ascend in this order.</p>
      <Entries entries={RANGES} />
      <hr />
      <Entries entries={[...COUNTS, ...others()]} />
    </>
  );
}

export function BumplessFields() {
  return (
    <div class="entries">
      <SwitchField path="bumpless.ramp" name="Ramp" about="Demand, Q, R and λ blend over N_sw cycles" />
      <SwitchField
        path="bumpless.integrator_alignment"
        name="Integrator alignment"
        about="Integrators are reset so that the demand continues"
      />
      <SwitchField
        path="bumpless.warm_start_projection"
        name="Warm-start projection"
        about="The first iterate is the last command, projected onto the new bounds"
      />
    </div>
  );
}
