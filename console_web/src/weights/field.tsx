// One parameter: the draft's value, a badge with the active one when it differs, its range and
// the vehicle's objection if there is one.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { compact } from "../lib/format";
import { UndoIcon } from "../ui/icons";
import { draft } from "./draft";
import "./field.css";
import { isOutside, rangeOf, rangeText } from "./ranges";

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

function parse(text: string): number | undefined {
  const plain = text.trim().replace(",", ".");
  return NUMBER.test(plain) ? Number(plain) : undefined;
}

function show(value: number | undefined): string {
  return value === undefined ? "" : String(value);
}

/** What the vehicle or the server said against this field. */
function objection(path: string): string {
  const apply = draft.apply.value;
  if (apply.state !== "refused") return "";
  const bare = path.replace(/\[\d+\]$/, "");
  const found = apply.refusal.problems.find((p) => p.field === path || p.field === bare);
  return found?.rule ?? "";
}

export function NumberField({ path, name, integer }: { path: string; name: string; integer?: boolean }) {
  const value = draft.value(path) as number | undefined;
  const text = useSignal(show(value));
  useEffect(() => {
    if (parse(text.value) !== value) text.value = show(value);
  }, [value]);
  useEffect(() => () => draft.setValid(path, true), [path]);

  if (value === undefined) return <span class="muted">–</span>;
  const number = parse(text.value);
  const malformed = number === undefined || (integer === true && !Number.isInteger(number));
  const range = rangeText(rangeOf(path));
  const wanted = integer ? "Must be a whole number." : "Must be a number.";
  const outside = !malformed && isOutside(path, number) ? `Must be ${range}.` : "";
  const problem = malformed ? wanted : objection(path) || outside;
  const edit = (next: string): void => {
    text.value = next;
    const parsed = parse(next);
    const valid = parsed !== undefined && (!integer || Number.isInteger(parsed));
    draft.setValid(path, valid);
    if (valid) draft.set(path, parsed);
  };
  const leave = (): void => {
    draft.endEdit();
    if (!draft.invalid.value.has(path)) return;
    draft.setValid(path, true);
    text.value = show(value);
  };
  return (
    <span class="field" data-differs={draft.differs(path) ? "yes" : undefined}>
      <input
        class="num"
        inputMode="decimal"
        aria-label={name}
        aria-invalid={problem !== ""}
        title={[path, range && `Range ${range}`, problem].filter(Boolean).join("\n")}
        data-path={path}
        value={text.value}
        onInput={(event) => edit(event.currentTarget.value)}
        onBlur={leave}
      />
      <Difference path={path} name={name} />
      {problem && (
        <span class="field-problem" role="alert">
          {problem}
        </span>
      )}
    </span>
  );
}

export function SwitchField({ path, name, about }: { path: string; name: string; about: string }) {
  const value = draft.value(path) as boolean | undefined;
  if (value === undefined) return null;
  return (
    <span class="field switch" data-differs={draft.differs(path) ? "yes" : undefined}>
      <label title={about}>
        <input
          type="checkbox"
          role="switch"
          checked={value}
          data-path={path}
          onChange={(event) => draft.set(path, event.currentTarget.checked)}
        />
        <span>{name}</span>
      </label>
      <Difference path={path} name={name} />
    </span>
  );
}

function Difference({ path, name }: { path: string; name: string }) {
  if (!draft.differs(path)) return null;
  const active = draft.active.value[path];
  const text = typeof active === "boolean" ? (active ? "on" : "off") : compact(active, 6);
  return (
    <button
      type="button"
      class="difference"
      title={`Active: ${text}. Press to revert.`}
      aria-label={`${name}: active value ${text}, revert`}
      onClick={() => draft.revert(path)}
    >
      <span class="num">{text}</span>
      <UndoIcon size={11} />
    </button>
  );
}
