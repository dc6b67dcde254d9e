// How the Live view is arranged: in the address ("#/live?as=wall"), else as it was last chosen.
import { computed, signal } from "@preact/signals";
import { address, go } from "../shell/address";

export const ARRANGEMENTS = [
  { value: "operate", name: "Operate", about: "Four questions: where, doing what, following, margin" },
  { value: "engineer", name: "Engineer", about: "Everything: scene, plots, wrench, actuators, events" },
  { value: "wall", name: "Wall", about: "The little that counts, to be read from three metres" },
] as const;
export type Arrangement = (typeof ARRANGEMENTS)[number]["value"];

const KEY = "bumpless.arrangement";

function known(name: string | null | undefined): Arrangement | undefined {
  return ARRANGEMENTS.find(({ value }) => value === name)?.value;
}

function kept(): Arrangement {
  try {
    return known(localStorage.getItem(KEY)) ?? "engineer";
  } catch {
    return "engineer";
  }
}

const chosen = signal<Arrangement>(kept());

export const arrangement = computed((): Arrangement => known(address.value.query.as) ?? chosen.value);

export function arrange(next: Arrangement): void {
  chosen.value = next;
  try {
    localStorage.setItem(KEY, next);
  } catch {
    // Without storage the choice lasts as long as the page.
  }
  go("live", "", { as: next });
}
