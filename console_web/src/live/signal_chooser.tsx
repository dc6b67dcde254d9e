// Which signals are plotted, the layouts that were saved, and what is drawn beside the measured lines.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { runs } from "../api/resources";
import { CrossIcon } from "../ui/icons";
import { FORECAST, haunt, haunted, trouble } from "./ghost";
import { dropLayout, group, layouts, own, saveLayout, signals, toggleSignal } from "./signals";

export function SignalChooser({ onClose }: { onClose: () => void }) {
  const wanted = useSignal("");
  const search = useRef<HTMLInputElement>(null);
  useEffect(() => search.current?.focus(), []);
  const found = signals().filter(({ id, title }) =>
    `${id} ${title}`.toLowerCase().includes(wanted.value.trim().toLowerCase()),
  );
  return (
    <div
      class="signal-chooser"
      role="group"
      aria-label="Signals"
      onKeyDown={(e) => e.key === "Escape" && onClose()}
    >
      <div class="signal-line">
        <input
          ref={search}
          type="search"
          aria-label="Search signals"
          placeholder="Search signals"
          value={wanted.value}
          onInput={(event) => {
            wanted.value = event.currentTarget.value;
          }}
        />
        <button type="button" class="quiet small" aria-label="Close" onClick={onClose}>
          <CrossIcon size={12} />
        </button>
      </div>
      <ul class="signal-list" aria-label="Signals found">
        {found.map(({ id, title, unit }) => (
          <li key={id}>
            <label>
              <input
                type="checkbox"
                checked={own.value.includes(id)}
                onChange={() => {
                  toggleSignal(id);
                  group.value = "Own";
                }}
              />{" "}
              {title} <span class="unit">{unit}</span>
            </label>
          </li>
        ))}
        {!found.length && <li class="muted">Nothing of that name.</li>}
      </ul>
      <Layouts />
      <GhostChoice />
    </div>
  );
}

function Layouts() {
  const name = useSignal("");
  return (
    <form
      class="signal-line"
      onSubmit={(event) => {
        event.preventDefault();
        saveLayout(name.value);
        name.value = "";
      }}
    >
      {Object.entries(layouts.value).map(([called, ids]) => (
        <span key={called} class="layout">
          <button
            type="button"
            class="action small"
            onClick={() => {
              own.value = ids;
              group.value = "Own";
            }}
          >
            {called}
          </button>
          <button
            type="button"
            class="quiet small"
            aria-label={`Forget the layout ${called}`}
            onClick={() => dropLayout(called)}
          >
            <CrossIcon size={10} />
          </button>
        </span>
      ))}
      <input
        aria-label="Name of the layout"
        placeholder="Name this layout"
        maxLength={40}
        value={name.value}
        onInput={(event) => {
          name.value = event.currentTarget.value;
        }}
      />
      <button type="submit" class="action small">
        Save
      </button>
    </form>
  );
}

function GhostChoice() {
  return (
    <label class="signal-line">
      <span class="muted">Beside it, dotted</span>
      <select class="small" value={haunted.value} onChange={(event) => void haunt(event.currentTarget.value)}>
        <option value="">nothing</option>
        <option value={FORECAST}>the forecast of this mission</option>
        {(runs.value ?? [])
          .filter(({ state, piece }) => state !== "recording" && piece <= 1)
          .map(({ id }) => (
            <option key={id} value={id}>
              {id}
            </option>
          ))}
      </select>
      {trouble.value && (
        <span class="lost" role="alert">
          {trouble.value}
        </span>
      )}
    </label>
  );
}
