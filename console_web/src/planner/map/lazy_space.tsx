// The plan in space, read when it is first wanted.
import { effect, signal } from "@preact/signals";
import type { ComponentType } from "preact";

const KEY = "bumpless.plan.space";

function kept(): boolean {
  try {
    return localStorage.getItem(KEY) === "yes";
  } catch {
    return false;
  }
}

/** The plan in space is shown beside the plan from above. */
export const spaceShown = signal(kept());
const loaded = signal<ComponentType | undefined>(undefined);

effect(() => {
  if (!spaceShown.value || loaded.peek()) return;
  void import("../space/space").then(({ Space }) => {
    loaded.value = Space;
  });
});

export function toggleSpace(): void {
  spaceShown.value = !spaceShown.peek();
  try {
    localStorage.setItem(KEY, spaceShown.peek() ? "yes" : "no");
  } catch {
    // Without storage the choice lasts as long as the page.
  }
}

export function LazySpace() {
  const Space = loaded.value;
  if (!spaceShown.value) return null;
  return Space ? <Space /> : <div class="plan-water space" />;
}
