// Named sets of parameters: save the draft, load into the draft, delete; and the vehicle's defaults.
import { useSignal } from "@preact/signals";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { presets } from "../api/resources";
import { live } from "../stream/store";
import { ActButton } from "../ui/act_button";
import { HoldButton } from "../ui/hold_button";
import { TrashIcon } from "../ui/icons";
import { Empty } from "../ui/panel";
import { RefusalNotice } from "../ui/refusal";
import { draft } from "./draft";
import { flatOfJson, flatOfMessage, jsonOfFlat } from "./flat";
import "./presets.css";

const NAME = /^[A-Za-z0-9][A-Za-z0-9_-]{0,63}$/;

export function Presets() {
  const name = useSignal("");
  const loaded = useSignal("");
  const refused = useSignal<{ title: string; refusal: Refusal } | undefined>(undefined);
  const names = (presets.value ?? []).map((preset) => preset.name);
  const valid = NAME.test(name.value);

  const load = async (preset: string): Promise<void> => {
    const answer = await ask("get", "/api/presets/{name}", { path: { name: preset } });
    refused.value = answer.ok ? undefined : { title: `${preset} not loaded.`, refusal: answer };
    if (!answer.ok) return;
    draft.load(flatOfJson(answer.value.parameters));
    loaded.value = preset;
  };
  const save = async (): Promise<void> => {
    const kept = name.value;
    const answer = await ask("put", "/api/presets/{name}", {
      path: { name: kept },
      body: jsonOfFlat(draft.whole()),
    });
    refused.value = answer.ok ? undefined : { title: `${kept} not saved.`, refusal: answer };
    if (!answer.ok) return;
    loaded.value = kept;
    name.value = "";
    await presets.refresh();
  };
  const remove = async (preset: string): Promise<void> => {
    const answer = await ask("delete", "/api/presets/{name}", { path: { name: preset } });
    refused.value = answer.ok ? undefined : { title: `${preset} not deleted.`, refusal: answer };
    await presets.refresh();
  };
  const reset = (): void => {
    const defaults = live.latest("tlm/parameters")?.defaults;
    if (defaults) draft.load(flatOfMessage(defaults));
    loaded.value = "Defaults";
  };

  return (
    <div class="presets">
      <ul class="rows">
        <li class="preset">
          <span class="ellipsis">
            <b>Defaults</b> <span class="muted">vehicle file</span>
          </span>
          <button type="button" class="action small" onClick={reset}>
            Load
          </button>
          <span />
        </li>
        {names.map((preset) => (
          <li key={preset} class="preset">
            <span class="ellipsis" title={preset}>
              {preset}
            </span>
            <button
              type="button"
              class="action small"
              aria-label={`Load ${preset} into the draft`}
              onClick={() => void load(preset)}
            >
              Load
            </button>
            <HoldButton
              name={`Delete preset ${preset}`}
              class="danger small"
              holdMs={700}
              title="Press and hold to delete"
              onHeld={() => void remove(preset)}
            >
              <TrashIcon size={12} />
            </HoldButton>
          </li>
        ))}
      </ul>
      {presets.refusal && <Empty>Presets cannot be read: {presets.refusal.reason}</Empty>}
      {loaded.value && draft.changedPaths.value.length > 0 && (
        <p class="hint">{loaded.value} is in the draft. Apply to fly with it.</p>
      )}
      <form
        class="save-preset"
        onSubmit={(event) => {
          event.preventDefault();
          void save();
        }}
      >
        <input
          aria-label="Name of the preset"
          placeholder="Name for this draft"
          value={name.value}
          aria-invalid={name.value !== "" && !valid}
          title="Letters, digits, - and _"
          onInput={(event) => {
            name.value = event.currentTarget.value;
          }}
        />
        <ActButton
          type="submit"
          class="action small"
          why={valid ? "" : name.value ? "Letters, digits, - and _ only" : "Give the draft a name first"}
        >
          Save draft
        </ActButton>
      </form>
      {refused.value && (
        <RefusalNotice
          {...refused.value}
          onClose={() => {
            refused.value = undefined;
          }}
        />
      )}
    </div>
  );
}
