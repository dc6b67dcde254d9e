// The tool in hand, and how fine things are placed.
import { computed, effect, signal } from "@preact/signals";

export type Tool = "select" | "waypoint" | "dock" | "keep-out" | "keep-in" | "current" | "wave" | "measure";
export const tool = signal<Tool>("select");
/** Metres; 0: no grid to snap to. */
export const grid = signal(0.5);
/** Drawn with north up, or with the dock's heading up. */
export const dockUp = signal(false);
export const measured = signal<readonly (readonly [north: number, east: number])[]>([]);

/** The tool draws an outline. */
export const outlining = computed(() => tool.value === "keep-out" || tool.value === "keep-in");

effect(() => {
  if (tool.value !== "measure" && measured.peek().length > 0) measured.value = [];
});

export const TOOLS: readonly { id: Tool; name: string; key: string; about: string }[] = [
  {
    id: "select",
    name: "Select",
    key: "V",
    about: "Select and drag; drag on the water for a box, hold Space to pan",
  },
  { id: "waypoint", name: "Waypoint", key: "W", about: "Each click on the water adds a waypoint" },
  {
    id: "dock",
    name: "Dock",
    key: "D",
    about: "Press where the dock is and drag towards its inside for the heading",
  },
  {
    id: "keep-out",
    name: "Keep out",
    key: "Z",
    about: "Draw a zone that no leg may lead through: click its corners, or drag a rectangle",
  },
  {
    id: "keep-in",
    name: "Keep in",
    key: "B",
    about: "Draw the boundary that no leg may leave: click its corners, or drag a rectangle",
  },
  { id: "current", name: "Current", key: "C", about: "Drag on the water the way the current flows" },
  {
    id: "wave",
    name: "Waves",
    key: "S",
    about: "Drag on the water the way the waves travel; farther is higher",
  },
  { id: "measure", name: "Measure", key: "M", about: "Click two or more points for distance and heading" },
];
