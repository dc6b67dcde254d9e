// What if: change what the plan itself does not say, and see both side by side.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { fixed, signed } from "../../lib/format";
import { CrossIcon } from "../../ui/icons";
import "../../ui/table.css";
import { endingNamed } from "../../ui/endings";
import { fields, rangeOf, refusal } from "../forms/fields";
import { NumberInput } from "../forms/number_input";
import { vehicle as planned, vehicles } from "../map/figures";
import { short } from "../model/document";
import { along, bearing } from "../model/geometry";
import type { PlanEvent } from "../model/mission";
import { mission } from "../model/plan";
import { plan } from "./forecast";
import type { Forecast } from "./foresight";
import { adopt, changes, current, FIGURES, failed, follow, forecast, varied, vehicle } from "./what_if";

const PREFIX = "parameters.";

export function WhatIf() {
  useEffect(() => follow(), []);
  return (
    <div class="form">
      <h3 class="form-title">What if …</h3>
      <Current />
      <label class="field-row">
        <span class="field-label">Another vehicle flies it</span>
        <select
          aria-label="What if: vehicle"
          value={vehicle.value || mission.value.vehicle}
          onChange={(event) => {
            vehicle.value = event.currentTarget.value;
          }}
        >
          {vehicles.value.map((id) => (
            <option key={id} value={id}>
              {id}
            </option>
          ))}
        </select>
      </label>
      <Failed />
      {changes.value.map((change, i) => (
        <Changed key={change.path} index={i} />
      ))}
      <Add />
      {varied.value ? (
        <>
          <Comparison />
          <button
            type="button"
            class="action small"
            title="Write these changes into the plan; undo takes them back"
            onClick={adopt}
          >
            Make it the plan
          </button>
        </>
      ) : (
        <p class="hint">Change something above: both are flown, 200 times each.</p>
      )}
    </div>
  );
}

function Current() {
  const shown = current.value ?? mission.value.current;
  const speed = short(Math.hypot(shown[0], shown[1]));
  const way = speed > 0 ? short(bearing([0, 0, 0], shown), 1) : 0;
  const set = (metres: number, degrees: number): void => {
    current.value = along([0, 0, shown[2]], degrees, metres).map((v) => short(v)) as unknown as [
      number,
      number,
      number,
    ];
  };
  return (
    <div class="field-block">
      <span class="field-label">
        Current
        {current.value && (
          <button
            type="button"
            class="quiet tiny"
            aria-label="The plan's own current"
            onClick={() => {
              current.value = undefined;
            }}
          >
            <CrossIcon size={10} />
          </button>
        )}
      </span>
      <div class="field-cells">
        <NumberInput
          name="What if: speed of the current"
          label="speed"
          unit="m/s"
          title="0 to 5 m/s"
          value={speed}
          refuse={within(0, 5)}
          onGive={(value) => value !== undefined && set(value, way)}
        />
        <NumberInput
          name="What if: direction of the current"
          label="towards"
          unit="deg"
          title="From north over east, the way it flows"
          value={way}
          refuse={within(-360, 360)}
          onGive={(value) => value !== undefined && set(speed, value)}
        />
      </div>
    </div>
  );
}

/** An actuator that fails, when, and what is left of it. */
function Failed() {
  const known = planned.value?.actuators ?? [];
  const fault = failed.value;
  const change = (part: Partial<PlanEvent>): void => {
    if (fault) failed.value = { ...fault, ...part };
  };
  return (
    <div class="field-block">
      <label class="field-row">
        <span class="field-label">An actuator fails</span>
        <select
          aria-label="What if: actuator that fails"
          value={fault?.of ?? ""}
          onChange={(event) => {
            const of = event.currentTarget.value;
            failed.value = of ? { from: 0, left: 0, ...fault, of, to: undefined } : undefined;
          }}
        >
          <option value="">none but the plan's</option>
          {known.map((id) => (
            <option key={id} value={id}>
              {id}
            </option>
          ))}
        </select>
      </label>
      {fault && (
        <div class="field-cells">
          <NumberInput
            name="What if: when it fails"
            label="at"
            unit="s"
            title="0 to 100000 s"
            value={fault.from}
            refuse={within(0, 1e5)}
            onGive={(value) => value !== undefined && change({ from: value })}
          />
          <NumberInput
            name="What if: force that is left"
            label="left of its force"
            unit="%"
            title="0 to 100 %"
            value={100 * fault.left}
            refuse={within(0, 100)}
            onGive={(value) => value !== undefined && change({ left: value / 100 })}
          />
        </div>
      )}
    </div>
  );
}

function within(low: number, high: number): (value: number) => string {
  return (value) => (value < low || value > high ? `must be from ${low} to ${high}` : "");
}

function Changed({ index }: { index: number }) {
  const change = changes.value[index];
  const field = fields.value?.find(({ path }) => path === PREFIX + change?.path);
  if (!change || !field) return null;
  const put = (value: number | undefined): void => {
    changes.value = changes.peek().map((one, i) => (i === index ? { ...one, value } : one));
  };
  return (
    <div class="field-row">
      <span class="field-label" title={field.help}>
        <button
          type="button"
          class="quiet tiny"
          aria-label={`Leave out ${change.path}`}
          onClick={() => {
            changes.value = changes.peek().filter((_, i) => i !== index);
          }}
        >
          <CrossIcon size={10} />
        </button>
        <span class="code">{change.path}</span>
      </span>
      <NumberInput
        name={`What if: ${change.path}`}
        unit={field.unit}
        title={`${field.label}\n${rangeOf(field)}`}
        value={change.value}
        placeholder="vehicle's own"
        optional
        refuse={(value) => refusal(field, value)}
        onGive={put}
      />
    </div>
  );
}

function Add() {
  const typed = useSignal("");
  const known = (fields.value ?? []).filter(
    ({ path, type }) => path.startsWith(PREFIX) && (type === "number" || type === "integer"),
  );
  const add = (path: string): void => {
    typed.value = path;
    if (!known.some((field) => field.path === PREFIX + path)) return;
    if (!changes.peek().some((change) => change.path === path))
      changes.value = [...changes.peek(), { path, value: undefined }];
    typed.value = "";
  };
  return (
    <label class="field-block">
      <span class="field-label">Another weight, threshold or gain</span>
      <input
        aria-label="What if: parameter"
        list="what-if-parameters"
        placeholder="supervisor.range_fr_lower_m"
        value={typed.value}
        onInput={(event) => add(event.currentTarget.value)}
      />
      <datalist id="what-if-parameters">
        {known.map(({ path, label }) => (
          <option key={path} value={path.slice(PREFIX.length)}>
            {label}
          </option>
        ))}
      </datalist>
    </label>
  );
}

function ending(of: Forecast | undefined): string {
  const word = of?.nominal?.outcome.ending;
  return word ? (endingNamed(word)?.word ?? word) : "–";
}

function Comparison() {
  const [a, b] = [plan.current.value ? plan.forecast.value : undefined, forecast.value];
  const wrong = b?.problems[0];
  if (wrong) return <p class="lost">{`${wrong.field}: ${wrong.rule}`}</p>;
  if (b?.state === "failed") return <p class="lost">{b.reason}</p>;
  return (
    <table class="table compact legs" aria-label="Plan and what if">
      <thead>
        <tr>
          <th scope="col">Figure</th>
          <th scope="col" class="num">
            Plan
          </th>
          <th scope="col" class="num">
            What if
          </th>
          <th scope="col" class="num">
            Change
          </th>
        </tr>
      </thead>
      <tbody>
        <tr>
          <th scope="row">Ends</th>
          <td class="num">{ending(a)}</td>
          <td class="num">{ending(b)}</td>
          <td />
        </tr>
        {FIGURES.map((figure) => {
          const [one, other] = [a && figure.of(a), b && figure.of(b)];
          return (
            <tr key={figure.name}>
              <th scope="row">
                {figure.name} <span class="unit">{figure.unit}</span>
              </th>
              <td class="num">{fixed(one, figure.decimals)}</td>
              <td class="num">{fixed(other, figure.decimals)}</td>
              <td class="num">
                {one === undefined || other === undefined ? "–" : signed(other - one, figure.decimals)}
              </td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
