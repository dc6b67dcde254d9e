// What the forms about people are made of: a line of fields, one button, and the refusal below.
import type { Signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import type { Refusal } from "../api/http";
import { RefusalIn } from "../ui/refusal";

interface FormProps {
  name: string;
  /** What the button says. */
  does: string;
  submit: () => Promise<void>;
  refused: string;
  refusal: Signal<Refusal | undefined>;
  /** Between the button and the refusal: what came of it. */
  told?: ComponentChildren;
  children: ComponentChildren;
}

export function Form({ name, does, submit, refused, refusal, told, children }: FormProps) {
  return (
    <form
      class="system-form"
      aria-label={name}
      autocomplete="off"
      onSubmit={(event) => {
        event.preventDefault();
        void submit();
      }}
    >
      {children}
      <button type="submit" class="action">
        {does}
      </button>
      {told}
      <RefusalIn title={refused} of={refusal} />
    </form>
  );
}

interface FieldProps {
  label: string;
  of: Signal<string>;
  type?: "text" | "number" | "password";
  min?: number;
  max?: number;
  minLength?: number;
  maxLength?: number;
  placeholder?: string;
  title?: string;
  autocomplete?: "off" | "current-password" | "new-password";
  /** A name as it is typed: no capitals, no spelling. */
  verbatim?: boolean;
}

/** A field that must be filled; its text is the signal's. */
export function Field({ label, of, verbatim, ...input }: FieldProps) {
  const typed = verbatim ? { autocapitalize: "none", spellcheck: false } : {};
  const given: object = { ...input, ...typed }; // JSX knows one set of attributes for each type of input
  return (
    <label>
      {label}
      <input
        required
        value={of.value}
        onInput={(event) => {
          of.value = event.currentTarget.value;
        }}
        {...given}
      />
    </label>
  );
}

const SECRET = { type: "password", minLength: 10, maxLength: 200, autocomplete: "new-password" } as const;

/** A password to be chosen. */
export function NewPassword(props: { label: string; of: Signal<string> }) {
  return <Field {...SECRET} title="At least ten characters" {...props} />;
}
