// A finding's change of the document, made with one press.
import { fitSoon } from "../map/camera";
import { short } from "../model/document";
import { EVENTS } from "../model/event_kinds";
import type { Ned } from "../model/geometry";
import { dockEdits, moveEdits } from "../model/operations";
import { pathOf } from "../model/paths";
import { edit, mission } from "../model/plan";
import { EVENT_PATHS } from "../model/things";
import type { Mend } from "./foresight";

function place(value: Mend["value"]): Ned | undefined {
  return Array.isArray(value) && value.length === 3 ? (value as unknown as Ned) : undefined;
}

/** Make the change; what hangs on the dock goes along with it. */
export function mend({ label, path, value }: Mend): void {
  const view = mission.peek();
  fitSoon.value = true;
  const to = place(value);
  if (path === "target.heading_deg" && typeof value === "number")
    edit(label, dockEdits(view, { heading: value }));
  else if (path === "target.standoff_m" && typeof value === "number")
    edit(label, dockEdits(view, { standoff: value }));
  else if (path === "target.position_ned_m" && to) edit(label, moveEdits(view, new Map([["dock", to]])));
  else {
    const leg = /^legs\[(\d+)\]\.to_ned_m$/.exec(path)?.[1];
    if (leg !== undefined && to) edit(label, moveEdits(view, new Map([[`leg:${leg}`, to]])));
    else {
      const put = typeof value === "number" ? short(value, 6) : (value ?? undefined);
      edit(label, [{ path: pathOf(path), value: put }]);
    }
  }
}

/** The thing that a field belongs to, to select it; undefined for the mission as a whole. */
export function thingOf(path: string): string | undefined {
  const leg = /^legs\[(\d+)\]/.exec(path)?.[1];
  if (leg !== undefined) return `leg:${leg}`;
  if (path.startsWith("target")) return "dock";
  if (path.startsWith("start")) return "start";
  for (const kind of EVENTS) {
    const [first = "", second] = EVENT_PATHS[kind].map(String);
    const list = second ? `${first}.${second}` : first;
    if (path.startsWith(`${list}[`)) return `${kind}:${Number.parseInt(path.slice(list.length + 1), 10)}`;
  }
  const zone = /^keep_out\[(\d+)\]/.exec(path)?.[1];
  if (zone !== undefined) return `zone:${zone}`;
  if (path.startsWith("keep_in")) return "fence";
  if (path.startsWith("environment.wave")) return "wave";
  return path.startsWith("environment") ? "current" : undefined;
}
