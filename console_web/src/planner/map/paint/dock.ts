// The dock with its approach and the place before it.
import { colour } from "../../../lib/theme";
import { type Ned, observationPoint, turn } from "../../model/geometry";
import { approachOf, type MissionView } from "../../model/mission";
import { arm } from "../grips";
import { angle, type Ctx, px, type Scene, TAU } from "./scene";
import { handle } from "./strokes";
import { text } from "./words";

export function paintDock(c: Ctx, s: Scene, dock: NonNullable<MissionView["dock"]>): void {
  const on = s.selected.includes("dock");
  const [x, y] = px(s, dock.at);
  const end = observationPoint(dock.at, dock.heading, dock.standoff);
  const [ox, oy] = px(s, end);
  handle(c, s, dock.at, dock.heading, arm(s.viewport));
  c.save();
  c.translate(x, y);
  c.rotate(angle(s, dock.heading));
  c.strokeStyle = colour("--warning");
  c.lineWidth = on ? 4 : 3;
  c.lineCap = "round";
  c.beginPath();
  c.moveTo(-9, -11);
  c.lineTo(4, -11);
  c.lineTo(4, 11);
  c.lineTo(-9, 11);
  c.stroke();
  c.restore();
  c.strokeStyle = colour("--mode-hover");
  c.lineWidth = 2;
  c.beginPath();
  c.arc(ox, oy, on ? 7 : 4, 0, TAU);
  c.stroke();
  text(c, dockLabel(dock, s.view.current), x + 14, y - 14, on ? "--ink" : "--ink-2", 600);
}

function dockLabel(dock: NonNullable<MissionView["dock"]>, current: Ned): string {
  const own = `Dock ${degrees(dock.heading)}`;
  const used = approachOf(dock, current);
  return Math.abs(turn(dock.heading, used)) > 0.5 ? `${own}, approach ${degrees(used)}` : own;
}

function degrees(heading: number): string {
  return `${heading.toFixed(0).padStart(3, "0")}°`;
}
