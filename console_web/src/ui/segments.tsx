// A few choices of which one holds.
import "./segments.css";

interface Choice<T> {
  value: T;
  name: string;
  about?: string;
}

interface SegmentsProps<T> {
  name: string;
  choices: readonly Choice<T>[];
  chosen: T;
  onChoose: (value: T) => void;
}

export function Segments<T extends string | number>({ name, choices, chosen, onChoose }: SegmentsProps<T>) {
  return (
    <div class="segments" role="group" aria-label={name}>
      {choices.map(({ value, name: text, about }) => (
        <button
          key={value}
          type="button"
          aria-pressed={chosen === value}
          title={about}
          onClick={() => onChoose(value)}
        >
          {text}
        </button>
      ))}
    </div>
  );
}
