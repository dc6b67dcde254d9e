// The ways a run can end: colour, shape and word together, never the colour alone.

import type { RunSummary } from "../api/types";
import { AlarmIcon, CheckIcon, ClockIcon, HollowIcon, StopIcon, UndoIcon, WarningIcon } from "./icons";

type Ending = NonNullable<RunSummary["outcome"]>;
export interface Look {
  word: string;
  look: string;
  Icon: typeof CheckIcon;
  about: string;
}

export const ENDINGS: Record<Ending, Look> = {
  docked: {
    word: "docked",
    look: "live",
    Icon: CheckIcon,
    about: "In hover within 0.15 m, 5° and 0.05 m/s of the observation point for the last 10 s",
  },
  held: { word: "held", look: "running", Icon: HollowIcon, about: "Over in hover, but not docked" },
  waved_off: {
    word: "waved off",
    look: "stale",
    Icon: UndoIcon,
    about: "The approach was given up for a safe place",
  },
  time_over: {
    word: "time over",
    look: "stale",
    Icon: ClockIcon,
    about: "The time was over before hover was reached",
  },
  aborted: { word: "aborted", look: "aborted", Icon: StopIcon, about: "Stopped before its end" },
  collided: {
    word: "collided",
    look: "lost",
    Icon: AlarmIcon,
    about: "The hull went through the dock's plane within 0.5 m of the marker",
  },
  interrupted: {
    word: "interrupted",
    look: "stale",
    Icon: WarningIcon,
    about: "The recording was cut off: nobody knows how the flight went on",
  },
};

export function endingNamed(word: string | undefined): Look | undefined {
  return ENDINGS[word as Ending];
}
