// Five priorities, each told by colour, shape and word.
import type { Alarm } from "../gen/bumpless_pb";
import { AlarmIcon, DiamondIcon, InfoIcon, StopIcon, WarningIcon } from "../ui/icons";

export interface PriorityLook {
  name: string;
  look: "critical" | "alarm" | "warning" | "low" | "note";
  Icon: typeof AlarmIcon;
}

const LOOKS: Record<number, PriorityLook> = {
  1: { name: "Critical", look: "critical", Icon: StopIcon },
  2: { name: "Alarm", look: "alarm", Icon: AlarmIcon },
  3: { name: "Warning", look: "warning", Icon: WarningIcon },
  4: { name: "Low", look: "low", Icon: DiamondIcon },
  5: { name: "Note", look: "note", Icon: InfoIcon },
};

/** Of an alarm; one from a server that tells no priority goes by its severity. */
export function priorityOf(alarm: Pick<Alarm, "priority" | "severity">): number {
  if (alarm.priority >= 1 && alarm.priority <= 5) return alarm.priority;
  return { 3: 2, 2: 3 }[alarm.severity as number] ?? 5;
}

export function lookOf(alarm: Pick<Alarm, "priority" | "severity">): PriorityLook {
  return LOOKS[priorityOf(alarm)] as PriorityLook;
}
