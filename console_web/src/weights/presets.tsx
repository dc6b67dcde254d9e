// Named sets of parameters: save the draft, load into the draft, delete; and the vehicle's defaults.
import type { JsonValue } from "@bufbuild/protobuf";
import { useState } from "preact/hooks";
import { request, type Refusal } from "../api/http";
import { presets } from "../api/resources";
import { live } from "../stream/store";
import { HoldButton } from "../ui/hold_button";
import { TrashIcon } from "../ui/icons";
import { Empty } from "../ui/panel";
import { RefusalNotice } from "../ui/refusal";
import { draft } from "./draft";
import { flatOfJson, flatOfMessage, jsonOfFlat } from "./flat";

const NAME = /^[A-Za-z0-9][A-Za-z0-9_-]{0,63}$/;

function url(name: string): string {
  return `api/presets/${encodeURIComponent(name)}`;
}

function nameOf(entry: unknown): string {
  return typeof entry === "string" ? entry : String((entry as { name?: unknown }).name ?? "");
}

export function Presets() {
  const { value: list, refusal: unread } = presets.use();
  const [name, setName] = useState("");
  const [loaded, setLoaded] = useState("");
  const [refusal, setRefusal] = useState<{ title: string; refusal: Refusal }>();
  const names = (list ?? []).map(nameOf).filter(Boolean);

  const load = async (preset: string): Promise<void> => {
    const answer = await request<Record<string, JsonValue>>("GET", url(preset));
    if (!answer.ok) return setRefusal({ title: `${preset} not loaded.`, refusal: answer });
    draft.load(flatOfJson(answer.value.parameters ?? answer.value));
    setRefusal(undefined);
    setLoaded(preset);
  };
  const save = async (): Promise<void> => {
    const answer = await request("PUT", url(name), jsonOfFlat(draft.whole()));
    if (!answer.ok) return setRefusal({ title: `${name} not saved.`, refusal: answer });
    setRefusal(undefined);
    setLoaded(name);
    setName("");
    await presets.refresh();
  };
  const remove = async (preset: string): Promise<void> => {
    const answer = await request("DELETE", url(preset));
    setRefusal(answer.ok ? undefined : { title: `${preset} not deleted.`, refusal: answer });
    await presets.refresh();
  };
  const reset = (): void => {
    const defaults = live.latest("tlm/parameters")?.defaults;
    if (defaults) draft.load(flatOfMessage(defaults));
    setLoaded("Defaults");
  };

  return (
    <div class="presets">
      <ul class="rows">
        <li class="preset">
          <span class="ellipsis"><b>Defaults</b> <span class="muted">vehicle file</span></span>
          <button type="button" class="action small" onClick={reset}>Load</button>
          <span />
        </li>
        {names.map((preset) => (
          <li key={preset} class="preset">
            <span class="ellipsis" title={preset}>{preset}</span>
            <button type="button" class="action small" aria-label={`Load ${preset} into the draft`} onClick={() => void load(preset)}>Load</button>
            <HoldButton name={`Delete preset ${preset}`} class="danger small" holdMs={700} title="Press and hold to delete" onHeld={() => void remove(preset)}>
              <TrashIcon size={12} />
            </HoldButton>
          </li>
        ))}
      </ul>
      {unread && <Empty>Presets cannot be read: {unread.reason}</Empty>}
      {loaded && draft.changeCount() > 0 && <p class="hint">{loaded} is in the draft. Apply to fly with it.</p>}
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
          value={name}
          aria-invalid={name !== "" && !NAME.test(name)}
          title="Letters, digits, - and _"
          onInput={(event) => setName(event.currentTarget.value)}
        />
        <button type="submit" class="action small" disabled={!NAME.test(name)}>Save draft</button>
      </form>
      {refusal && <RefusalNotice {...refusal} onClose={() => setRefusal(undefined)} />}
    </div>
  );
}
