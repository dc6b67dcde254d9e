// A counterfactual: the run's mission flown again with something changed, and compared at once.
import { signal, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { runs } from "../api/resources";
import type { RunSummary } from "../api/types";
import { go } from "../shell/address";
import { ActButton } from "../ui/act_button";
import { CrossIcon } from "../ui/icons";
import { ProblemTable, RefusalNotice } from "../ui/refusal";

const PATIENCE_MS = 310_000;
const ALLOCATORS = ["mdca", "wls", "pid_direct"];
/** What people ask for first; any other path can be typed. */
const PATHS = [
  "hover.lambda",
  "reverse.lambda",
  "forward.lambda",
  "hover.ramp_cycles",
  "reverse.ramp_cycles",
  "supervisor.range_fr_lower_m",
  "supervisor.range_rh_lower_m",
  "supervisor.dwell_cycles",
  "bumpless.ramp",
  "bumpless.integrator_alignment",
  "guidance.look_ahead_m",
];

const vehicles = signal<readonly string[]>([]);

async function loadVehicles(): Promise<void> {
  if (vehicles.peek().length) return;
  const answer = await ask("get", "/api/planning");
  if (answer.ok) vehicles.value = answer.value;
}

interface Change {
  path: string;
  value: string;
}

/** As typed: a number, true or false, a row of numbers, or a word. */
function typed(text: string): unknown {
  try {
    return JSON.parse(text.trim().replace(/^(-?\d+),(\d+)$/, "$1.$2"));
  } catch {
    return text.trim();
  }
}

export function FlyAgain({ run }: { run: RunSummary }) {
  const changes = useSignal<readonly Change[]>([{ path: "", value: "" }]);
  const vehicle = useSignal("");
  const allocator = useSignal("");
  const seen = useSignal("");
  const flying = useSignal(false);
  const refused = useSignal<Refusal | undefined>(undefined);
  useEffect(() => void loadVehicles(), []);
  const set = (index: number, change: Partial<Change>): void => {
    const next = changes.value.map((old, i) => (i === index ? { ...old, ...change } : old));
    if (next.at(-1)?.path) next.push({ path: "", value: "" });
    changes.value = next;
  };
  const fly = async (): Promise<void> => {
    const parameters = Object.fromEntries(
      changes.value.filter(({ path }) => path.trim()).map(({ path, value }) => [path.trim(), typed(value)]),
    );
    if (allocator.value) parameters["allocation.allocator"] = allocator.value;
    flying.value = true;
    refused.value = undefined;
    const answer = await ask("post", "/api/runs/{run}/refly", {
      path: { run: run.id },
      body: {
        parameters,
        vehicle: vehicle.value || null,
        seed: null,
        as_seen: seen.value === "" ? null : seen.value === "seen",
      },
      timeoutMs: PATIENCE_MS,
    });
    flying.value = false;
    refused.value = answer.ok ? undefined : answer;
    if (!answer.ok) return;
    await runs.refresh();
    go("runs", "", { compare: [run.id, answer.value.id].join() });
  };
  return (
    <details class="fly-again">
      <summary>Fly again with other numbers</summary>
      <form
        aria-label="Fly again"
        onSubmit={(event) => {
          event.preventDefault();
          void fly();
        }}
      >
        <datalist id="fly-again-paths">
          {PATHS.map((path) => (
            <option key={path} value={path} />
          ))}
        </datalist>
        {changes.value.map((change, index) => (
          <div key={index} class="fly-again-change">
            <input
              class="code"
              list="fly-again-paths"
              aria-label={`Parameter ${index + 1}`}
              placeholder="parameter, such as hover.lambda"
              value={change.path}
              onInput={(event) => set(index, { path: event.currentTarget.value })}
            />
            <input
              class="num"
              aria-label={`Value of parameter ${index + 1}`}
              placeholder="value"
              value={change.value}
              onInput={(event) => set(index, { value: event.currentTarget.value })}
            />
            {changes.value.length > 1 && index < changes.value.length - 1 && (
              <button
                type="button"
                class="quiet"
                aria-label={`Leave parameter ${index + 1} as it was`}
                onClick={() => {
                  changes.value = changes.value.filter((_, i) => i !== index);
                }}
              >
                <CrossIcon />
              </button>
            )}
          </div>
        ))}
        <div class="fly-again-change">
          <Choice name="Allocator" none="the run's" values={ALLOCATORS} chosen={allocator} />
          <Choice name="Vehicle" none="the run's" values={vehicles.value} chosen={vehicle} />
          <Choice
            name="World"
            none="as planned; as seen for a real vehicle"
            values={["planned", "seen"]}
            chosen={seen}
          />
        </div>
        <ActButton
          type="submit"
          class="action primary"
          why={flying.value ? "It is being flown: its comparison opens when it is done" : ""}
        >
          {flying.value ? "Flying" : "Fly and compare"}
        </ActButton>
        {flying.value && (
          <span class="muted" role="status">
            It is flown beside everything else, at low priority.
          </span>
        )}
      </form>
      {refused.value && (
        <>
          <RefusalNotice
            title="Not flown."
            refusal={refused.value}
            onClose={() => {
              refused.value = undefined;
            }}
          />
          {refused.value.problems.length > 0 && <ProblemTable problems={refused.value.problems} />}
        </>
      )}
    </details>
  );
}

interface ChoiceProps {
  name: string;
  none: string;
  values: readonly string[];
  chosen: { value: string };
}

function Choice({ name, none, values, chosen }: ChoiceProps) {
  return (
    <label>
      <span class="muted">{name}</span>
      <select
        class="small"
        aria-label={name}
        value={chosen.value}
        onChange={(event) => {
          chosen.value = event.currentTarget.value;
        }}
      >
        <option value="">{none}</option>
        {values.map((value) => (
          <option key={value} value={value}>
            {value}
          </option>
        ))}
      </select>
    </label>
  );
}
