// Seconds along the timeline.
import { computed } from "@preact/signals";
import { mission } from "../model/plan";

/** What the timeline spans, s: the mission's longest duration. */
export const lasts = computed(() => Math.max(1, mission.value.duration));

/** A time as a share of the timeline, for a style. */
export function share(seconds: number): string {
  return `${((100 * seconds) / lasts.value).toFixed(3)}%`;
}
