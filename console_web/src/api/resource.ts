// A thing of the server's that several components look at: fetched when first looked at, and when asked.
import { type Signal, signal } from "@preact/signals";
import type { Answer, Refusal } from "./http";

interface Got<T> {
  value?: T;
  refusal?: Refusal;
}

export class Resource<T> {
  private readonly got: Signal<Got<T>>;
  private asked = false;
  private turn = 0;

  constructor(private readonly fetch: () => Promise<Answer<T>>) {
    this.got = signal<Got<T>>({}, { watched: () => void (this.asked || this.refresh()) });
  }

  get value(): T | undefined {
    return this.got.value.value;
  }

  /** The value as it stands, for acting on it rather than showing it. */
  peek(): T | undefined {
    return this.got.peek().value;
  }

  /** Why the last request failed; the value before it stays. */
  get refusal(): Refusal | undefined {
    return this.got.value.refusal;
  }

  async refresh(): Promise<void> {
    this.asked = true;
    const turn = ++this.turn;
    const answer = await this.fetch();
    if (turn !== this.turn) return; // a later request has been sent: its answer counts
    this.got.value = answer.ok ? { value: answer.value } : { value: this.got.peek().value, refusal: answer };
  }
}
