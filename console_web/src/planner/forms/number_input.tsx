// A number typed exactly, with its unit and range: shown as it stands, taken when it is one that may stand.
import { useSignal } from "@preact/signals";
import { typed } from "./fields";

interface NumberInputProps {
  name: string;
  /** Shown before the field, short. */
  label?: string;
  unit: string;
  title: string;
  value: number | undefined;
  /** What holds while nothing is given. */
  placeholder?: string;
  /** May be empty: then nothing stands in the file. */
  optional?: boolean;
  refuse: (value: number) => string;
  onGive: (value: number | undefined) => void;
}

export function NumberInput(props: NumberInputProps) {
  const { name, label, unit, title, value, placeholder, optional, refuse, onGive } = props;
  const text = useSignal<string | undefined>(undefined);
  const shown = text.value ?? (value === undefined ? "" : String(value));
  const given = typed(shown);
  const why =
    shown.trim() === ""
      ? optional
        ? ""
        : "a number is needed"
      : given === undefined
        ? "must be a number"
        : refuse(given);
  const step = (by: number): void => {
    const next = Number(((given ?? value ?? 0) + by).toFixed(6));
    if (refuse(next)) return;
    text.value = undefined;
    onGive(next);
  };
  return (
    <label class="number-input" title={[title, why].filter(Boolean).join("\n")}>
      {label && <span class="muted">{label}</span>}
      <span class="number-box">
        <input
          inputMode="decimal"
          aria-label={name}
          aria-invalid={why !== ""}
          value={shown}
          placeholder={placeholder}
          onInput={(event) => {
            const next = event.currentTarget.value;
            text.value = next;
            const number = typed(next);
            if (next.trim() === "" && optional) onGive(undefined);
            else if (number !== undefined && !refuse(number)) onGive(number);
          }}
          onBlur={() => {
            text.value = undefined;
          }}
          onKeyDown={(event) => {
            if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
            event.preventDefault();
            step((event.key === "ArrowUp" ? 1 : -1) * (event.shiftKey ? 1 : 0.1));
          }}
        />
        {unit && <span class="unit">{unit === "deg" ? "°" : unit}</span>}
      </span>
      {why && text.value !== undefined && <span class="lost small-text">{why}</span>}
    </label>
  );
}
