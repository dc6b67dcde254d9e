// When a drawing over time is due anew: when it has moved on by a pixel, not with each message.
import type { History } from "../stream/history";
import { screen } from "../stream/screen";
import { shown } from "./time_axis";

export interface Drawn {
  of: History;
  from: number;
  to: number;
  /** Where the newest value stands: with flights ahead the window may hold still while it moves on. */
  edge: number;
  /** Rows that have been read of a run; a live history only grows at the edge that is compared. */
  rows: number;
  /** What stopped coming is drawn to its very end. */
  fresh: boolean;
}

/** Whether a drawing of this width, px, is due; said yes to, it counts as drawn. */
export type Pace = (width: number) => boolean;

export function pace(): Pace {
  let last: Drawn | undefined;
  return (width) => {
    const [from, to] = shown();
    const rows = screen.isLive ? 0 : screen.history.length;
    const now = {
      of: screen.history,
      from,
      to,
      edge: screen.until,
      rows,
      fresh: screen.isFresh("tlm/navigation"),
    };
    if (last && !isDue(last, now, (to - from) / width)) return false;
    last = now;
    return true;
  };
}

export function isDue(last: Drawn, now: Drawn, pixel: number): boolean {
  if (last.of !== now.of || last.rows !== now.rows || last.fresh !== now.fresh) return true;
  const moved = Math.max(...(["from", "to", "edge"] as const).map((one) => Math.abs(now[one] - last[one])));
  return !(moved < pixel); // before the first value nothing can be compared
}
