// The keys by where they work; the planner's come from its own table, with the planner.
export interface Keys {
  name: string;
  keys: readonly (readonly [keys: string, what: string])[];
}

export const SHORTCUTS: readonly Keys[] = [
  {
    name: "Everywhere",
    keys: [
      ["Ctrl+K or ⌘K", "find everything: views, missions, runs, words, commands"],
      ["?", "this sheet"],
      ["Tab, Enter, Space", "reach and press; Abort wants to be held for one second"],
      ["Escape", "close what is open"],
    ],
  },
  {
    name: "Plots",
    keys: [
      ["Space", "pause the plots, or go on with the present"],
      ["← and →", "back and forward in time by a tenth of the window (Shift: a whole one)"],
      ["+ and −", "a shorter or a longer window"],
      ["End", "back to the present"],
    ],
  },
  {
    name: "Replay",
    keys: [
      ["Space", "play and pause"],
      ["← and →", "one second back or forward (Shift: ten)"],
      [", and .", "one cycle back or forward"],
      ["Home, End", "the run's beginning and end"],
    ],
  },
];

export async function plannerKeys(): Promise<Keys> {
  const { KEYS } = await import("../planner/keys");
  return { name: "Plan", keys: KEYS };
}
