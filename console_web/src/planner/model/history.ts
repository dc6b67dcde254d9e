// Undo and redo without end: every state of a text with what led to it.

export interface Step {
  text: string;
  /** What was done, for the button's title. */
  label: string;
}

export class History {
  private steps: Step[];
  private at = 0;
  private key: string | undefined;

  constructor(text: string) {
    this.steps = [{ text, label: "" }];
  }

  get text(): string {
    return this.steps[this.at]?.text ?? "";
  }

  /** Add a state; steps that share a key and follow each other are one. */
  add(text: string, label: string, key?: string): void {
    if (text === this.text) return;
    const joins = key !== undefined && key === this.key && this.at > 0;
    this.key = key;
    const kept = this.steps.slice(0, joins ? this.at : this.at + 1);
    this.steps = [...kept, { text, label }];
    this.at = this.steps.length - 1;
  }

  /** Put another text in the place of the last state. */
  amend(text: string): void {
    const step = this.steps[this.at];
    if (step) this.steps[this.at] = { ...step, text };
  }

  /** What undo would take back; undefined when there is nothing. */
  get back(): string | undefined {
    return this.at > 0 ? this.steps[this.at]?.label : undefined;
  }

  get forth(): string | undefined {
    return this.steps[this.at + 1]?.label;
  }

  undo(): string | undefined {
    return this.go(-1);
  }

  redo(): string | undefined {
    return this.go(1);
  }

  private go(by: -1 | 1): string | undefined {
    const step = this.steps[this.at + by];
    if (!step) return undefined;
    this.at += by;
    this.key = undefined;
    return step.text;
  }
}
