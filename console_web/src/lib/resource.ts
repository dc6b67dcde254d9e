// A server resource that several components look at: fetched once, refreshed when asked.
import { useEffect, useReducer } from "preact/hooks";
import { request, type Refusal } from "../api/http";

export class Resource<T> {
  value: T | undefined;
  refusal: Refusal | undefined;
  loading = false;
  private readonly watchers = new Set<() => void>();
  private asked = false;
  private turn = 0;

  constructor(private readonly path: string) {}

  async refresh(): Promise<void> {
    this.asked = true;
    this.loading = true;
    const turn = ++this.turn;
    const answer = await request<T>("GET", this.path);
    if (turn !== this.turn) return; // a later request has been sent: its answer counts
    this.loading = false;
    this.refusal = answer.ok ? undefined : answer;
    if (answer.ok) this.value = answer.value;
    for (const watcher of this.watchers) watcher();
  }

  /** The resource, rendering again at each answer. The first user fetches it. */
  use(): this {
    const [, render] = useReducer((count: number) => count + 1, 0);
    useEffect(() => {
      const watcher = (): void => render(undefined as never);
      this.watchers.add(watcher);
      if (!this.asked) void this.refresh();
      return () => void this.watchers.delete(watcher);
    }, [this]);
    return this;
  }
}
