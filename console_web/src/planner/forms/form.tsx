// A form for any part of a mission, made from its declaration: label, unit, range and help for every field.
import type { ComponentChildren } from "preact";
import { ActButton } from "../../ui/act_button";
import { CrossIcon } from "../../ui/icons";
import { put } from "../model/document";
import { valueAt } from "../model/mission";
import { fieldOf, type Path } from "../model/paths";
import { edit, mission, reshape } from "../model/plan";
import { beginning, below, declared, type FieldEntry, fields, rangeOf, refusal } from "./fields";
import { NumberInput } from "./number_input";
import "./form.css";

/** What is known of a text's words: lists that the planner holds. */
const LISTS: Record<string, string> = {
  vehicle: "plan-vehicles",
  "faults[].actuator": "plan-actuators",
  "sea_floor.grid": "plan-grids",
};

interface PartProps {
  path: Path;
  /** Keys that stand elsewhere. */
  without?: readonly string[];
  only?: readonly string[];
}

/** All fields right below `path`; parts and lists open beneath. */
export function FormPart({ path, without = [], only }: PartProps) {
  const all = fields.value;
  if (!all)
    return <p class="hint">{fields.refusal ? `The form can't be read: ${fields.refusal.reason}` : ""}</p>;
  const shown = below(all, declared(path)).filter((field) => {
    const key = keyOf(field);
    return !without.includes(key) && (!only || only.includes(key));
  });
  return (
    <>
      {shown.map((field) => (
        <Field key={field.path} field={field} path={[...path, keyOf(field)]} />
      ))}
    </>
  );
}

function keyOf(field: FieldEntry): string {
  return field.path.split(".").at(-1) ?? "";
}

function give(field: FieldEntry, path: Path, value: unknown): void {
  edit(`Change ${field.label.toLowerCase()}`, [{ path, value }], fieldOf(path));
}

export function Field({ field, path }: { field: FieldEntry; path: Path }) {
  switch (field.type) {
    case "part":
      return <Part field={field} path={path} />;
    case "list":
      return <List field={field} path={path} />;
    case "row":
      return <Row field={field} path={path} />;
    case "number":
    case "integer":
      return (
        <Labelled field={field}>
          <NumberField field={field} path={path} />
        </Labelled>
      );
    case "switch":
      return <SwitchField field={field} path={path} />;
    case "choice":
      return (
        <Labelled field={field}>
          <ChoiceField field={field} path={path} />
        </Labelled>
      );
    case "text":
      return (
        <div class="field-block">
          <span class="field-label">{field.label}</span>
          <TextField field={field} path={path} />
        </div>
      );
  }
}

function Labelled({ field, children }: { field: FieldEntry; children: ComponentChildren }) {
  return (
    <div class="field-row">
      <span class="field-label" title={field.help || undefined}>
        {field.label}
      </span>
      {children}
    </div>
  );
}

function about(field: FieldEntry, index = 0): string {
  return [field.help, rangeOf(field, index)].filter(Boolean).join("\n");
}

function placeholder(value: unknown): string {
  return value === undefined || value === null ? "vehicle's own" : String(value);
}

function NumberField({ field, path }: { field: FieldEntry; path: Path }) {
  const value = valueAt(mission.value.raw, path);
  return (
    <NumberInput
      name={`${field.label}, ${fieldOf(path)}`}
      unit={field.unit}
      title={about(field)}
      value={typeof value === "number" ? value : undefined}
      placeholder={placeholder(field.default)}
      optional={!field.required}
      refuse={(number) => refusal(field, number)}
      onGive={(number) => give(field, path, number)}
    />
  );
}

function Row({ field, path }: { field: FieldEntry; path: Path }) {
  const value = valueAt(mission.value.raw, path);
  const present = Array.isArray(value) ? (value as unknown[]) : undefined;
  const names = field.names ?? present?.map((_, i) => String(i + 1)) ?? [];
  const otherwise = Array.isArray(field.default) ? (field.default as number[]) : undefined;
  if (names.length === 0) return null; // one for each command: as text
  return (
    <div class="field-block">
      <span class="field-label" title={field.help || undefined}>
        {field.label}
        {present && !field.required && (
          <button
            type="button"
            class="quiet tiny"
            aria-label={`Leave out ${field.label}`}
            title="Leave it out"
            onClick={() => give(field, path, undefined)}
          >
            <CrossIcon size={10} />
          </button>
        )}
      </span>
      <div class="field-cells" data-many={names.length > 3 ? "yes" : undefined}>
        {names.map((name, i) => (
          <NumberInput
            key={name}
            name={`${field.label} ${name}, ${fieldOf(path)}`}
            label={name}
            unit={field.unit.length > 3 ? "" : field.unit}
            title={about(field, i)}
            value={typeof present?.[i] === "number" ? (present[i] as number) : undefined}
            placeholder={String(otherwise?.[i] ?? 0)}
            optional={!present && !field.required}
            refuse={(number) => refusal(field, number, i)}
            onGive={(number) => {
              if (number === undefined) return;
              if (present) give(field, [...path, i], number);
              else
                give(
                  field,
                  path,
                  names.map((_, j) => (j === i ? number : (otherwise?.[j] ?? 0))),
                );
            }}
          />
        ))}
      </div>
    </div>
  );
}

function SwitchField({ field, path }: { field: FieldEntry; path: Path }) {
  const value = valueAt(mission.value.raw, path);
  return (
    <label class="field-row" title={field.help || undefined}>
      <span class="field-label">{field.label}</span>
      <input
        type="checkbox"
        aria-label={`${field.label}, ${fieldOf(path)}`}
        checked={typeof value === "boolean" ? value : field.default === true}
        onChange={(event) => give(field, path, event.currentTarget.checked)}
      />
    </label>
  );
}

function ChoiceField({ field, path }: { field: FieldEntry; path: Path }) {
  const value = valueAt(mission.value.raw, path);
  return (
    <select
      aria-label={`${field.label}, ${fieldOf(path)}`}
      title={field.help || undefined}
      value={typeof value === "string" ? value : String(field.default ?? "")}
      onChange={(event) => give(field, path, event.currentTarget.value)}
    >
      {(field.choices ?? []).map((word) => (
        <option key={word} value={word}>
          {word.replaceAll("_", " ")}
        </option>
      ))}
    </select>
  );
}

function TextField({ field, path }: { field: FieldEntry; path: Path }) {
  const value = valueAt(mission.value.raw, path);
  return (
    <input
      aria-label={`${field.label}, ${fieldOf(path)}`}
      title={field.help || field.form || undefined}
      list={LISTS[field.path]}
      value={typeof value === "string" ? value : value === undefined || value === null ? "" : String(value)}
      onInput={(event) => {
        const text = event.currentTarget.value;
        give(field, path, text === "" && !field.required ? undefined : text);
      }}
    />
  );
}

function Part({ field, path }: { field: FieldEntry; path: Path }) {
  const value = valueAt(mission.value.raw, path);
  const count = value && typeof value === "object" ? Object.keys(value).length : 0;
  return (
    <details class="field-part">
      <summary title={field.help || undefined}>
        {field.label}
        {count > 0 && <span class="tag">{count} set</span>}
      </summary>
      <div class="field-inner">
        {field.nullable && count === 0 ? (
          <button
            type="button"
            class="action small"
            onClick={() => give(field, path, beginning(fields.peek() ?? [], field.path))}
          >
            Add: {field.label.toLowerCase()}
          </button>
        ) : (
          <>
            <FormPart path={path} />
            {count > 0 && !field.required && (
              <button type="button" class="action small" onClick={() => give(field, path, undefined)}>
                Leave out: {field.label.toLowerCase()}
              </button>
            )}
          </>
        )}
      </div>
    </details>
  );
}

function List({ field, path }: { field: FieldEntry; path: Path }) {
  const value = valueAt(mission.value.raw, path);
  const entries = Array.isArray(value) ? (value as unknown[]) : [];
  const add = (): void =>
    reshape(`Add to ${field.label.toLowerCase()}`, (doc) => {
      put(doc, path, [...entries, beginning(fields.peek() ?? [], `${field.path}[]`)]);
    });
  const remove = (index: number): void =>
    reshape(`Remove from ${field.label.toLowerCase()}`, (doc) => {
      put(doc, entries.length === 1 ? path : [...path, index], undefined);
    });
  return (
    <details class="field-part">
      <summary title={field.help || undefined}>
        {field.label}
        {entries.length > 0 && <span class="tag">{entries.length}</span>}
      </summary>
      <div class="field-inner">
        {entries.map((_, i) => (
          <fieldset key={i} class="field-entry">
            <legend>
              {i + 1}
              <button
                type="button"
                class="quiet tiny"
                aria-label={`Remove ${field.label} ${i + 1}`}
                onClick={() => remove(i)}
              >
                <CrossIcon size={10} />
              </button>
            </legend>
            <FormPart path={[...path, i]} />
          </fieldset>
        ))}
        <ActButton
          class="action small"
          why={entries.length >= (field.most ?? 1e9) ? `At most ${field.most}` : ""}
          onAct={add}
        >
          Add one
        </ActButton>
      </div>
    </details>
  );
}
