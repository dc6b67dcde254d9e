// The open plan's forecast, and what follows from it for its start.
import { computed } from "@preact/signals";
import { text } from "../model/plan";
import { PlanForesight } from "./foresight";

export const plan = new PlanForesight(text);
export const hard = computed(() =>
  (plan.forecast.value?.findings ?? []).filter((f) => f.severity === "hard"),
);
export const soft = computed(() =>
  (plan.forecast.value?.findings ?? []).filter((f) => f.severity === "soft"),
);
/** Nothing of what is told is of another text. */
export const told = computed(() => plan.current.value && plan.forecast.value?.findings !== undefined);
