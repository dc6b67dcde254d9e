import { describe, expect, it } from "vitest";
import { Drafts, type Store } from "./drafts";

function memory(full = false): Store {
  const kept = new Map<string, string>();
  return {
    getItem: (key) => kept.get(key) ?? null,
    setItem: (key, value) => {
      if (full) throw new DOMException("full", "QuotaExceededError");
      kept.set(key, value);
    },
    removeItem: (key) => void kept.delete(key),
    key: (index) => [...kept.keys()][index] ?? null,
    get length() {
      return kept.size;
    },
  };
}

describe("drafts", () => {
  it("come back as they were kept, and go when they are dropped", () => {
    const drafts = new Drafts(memory());
    const draft = { text: "name: a # ä\n", base: "ab", changed: 1 };
    drafts.put("b", draft);
    drafts.put("a", draft);
    expect([drafts.names(), drafts.get("a")]).toEqual([["a", "b"], draft]);
    drafts.drop("a");
    expect([drafts.names(), drafts.get("a")]).toEqual([["b"], undefined]);
  });

  it("say so when the browser keeps nothing, and are not misled by what others wrote", () => {
    const store = memory();
    store.setItem("bumpless.plan.x", "no json");
    expect(new Drafts(store).get("x")).toBeUndefined();
    expect(new Drafts(memory(true)).put("x", { text: "", base: "", changed: 0 })).toBe(false);
  });
});
