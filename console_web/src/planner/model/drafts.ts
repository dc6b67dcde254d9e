// Unsaved work, kept by the browser so that it outlives a reload and a crash.

export interface Draft {
  text: string;
  /** Hash of the stored file that it began from; "" for a mission that was never stored. */
  base: string;
  /** When it was last changed, ms since 1970. */
  changed: number;
}

const PREFIX = "bumpless.plan.";

export interface Store {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
  removeItem(key: string): void;
  key(index: number): string | null;
  readonly length: number;
}

export class Drafts {
  constructor(private readonly store: Store) {}

  get(name: string): Draft | undefined {
    try {
      const told: unknown = JSON.parse(this.store.getItem(PREFIX + name) ?? "null");
      const draft = told as Draft | null;
      return draft && typeof draft.text === "string" ? { ...draft, base: draft.base ?? "" } : undefined;
    } catch {
      return undefined; // written by something else
    }
  }

  /** False when the browser keeps nothing: full, or told not to. */
  put(name: string, draft: Draft): boolean {
    try {
      this.store.setItem(PREFIX + name, JSON.stringify(draft));
      return true;
    } catch {
      return false;
    }
  }

  drop(name: string): void {
    try {
      this.store.removeItem(PREFIX + name);
    } catch {
      // Nothing is kept then.
    }
  }

  names(): string[] {
    const found: string[] = [];
    try {
      for (let i = 0; i < this.store.length; i++) {
        const key = this.store.key(i);
        if (key?.startsWith(PREFIX)) found.push(key.slice(PREFIX.length));
      }
    } catch {
      return [];
    }
    return found.sort();
  }
}
