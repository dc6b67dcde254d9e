// A value that components watch.
import { useEffect, useReducer } from "preact/hooks";

export interface Signal<T> {
  get(): T;
  set(next: T): void;
  /** The value; the calling component renders again when it is set. */
  use(): T;
}

export function signal<T>(first: T): Signal<T> {
  let value = first;
  const watchers = new Set<() => void>();
  return {
    get: () => value,
    set(next) {
      value = next;
      for (const watcher of watchers) watcher();
    },
    use() {
      const [, render] = useReducer((count: number) => count + 1, 0);
      useEffect(() => {
        const watcher = (): void => render(undefined as never);
        watchers.add(watcher);
        return () => void watchers.delete(watcher);
      }, []);
      return value;
    },
  };
}
