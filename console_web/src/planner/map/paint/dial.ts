// The current as a dial in the corner.
import { colour, font } from "../../../lib/theme";
import { DIAL, dialScale, dialTip } from "../grips";
import { type Ctx, type Scene, TAU } from "./scene";
import { dot } from "./strokes";

function arrow(c: Ctx, x: number, y: number, at: number, length: number): void {
  c.save();
  c.translate(x, y);
  c.rotate(at);
  c.beginPath();
  c.moveTo(0, 0);
  c.lineTo(length, 0);
  c.moveTo(length - 6, -4);
  c.lineTo(length, 0);
  c.lineTo(length - 6, 4);
  c.stroke();
  c.restore();
}

/** The current as a dial in the corner: its arrow is dragged. */
export function paintDial(c: Ctx, s: Scene): void {
  const { x, y, radius } = DIAL;
  const scale = dialScale(s.view.current);
  const on = s.selected.includes("current");
  c.fillStyle = colour("--panel");
  c.globalAlpha = 0.85;
  c.beginPath();
  c.arc(x, y, radius + 14, 0, TAU);
  c.fill();
  c.globalAlpha = 1;
  c.strokeStyle = colour(on ? "--accent" : "--line-2");
  c.lineWidth = on ? 2 : 1;
  for (const share of [0.5, 1]) {
    c.beginPath();
    c.arc(x, y, radius * share, 0, TAU);
    c.stroke();
  }
  c.fillStyle = colour("--ink-2");
  c.font = font("--text-2xs", 600);
  c.textAlign = "center";
  const north = -s.viewport.turn - Math.PI / 2;
  c.fillText("N", x + (radius + 7) * Math.cos(north), y + (radius + 7) * Math.sin(north) + 4);
  const [tx, ty] = dialTip(s.view.current, s.viewport);
  const speed = Math.hypot(s.view.current[0], s.view.current[1]);
  c.strokeStyle = colour("--trace");
  c.lineWidth = 2.5;
  if (speed > 1e-6) arrow(c, x, y, Math.atan2(ty - y, tx - x), Math.hypot(tx - x, ty - y));
  dot(c, tx, ty, speed > 1e-6 ? 4 : 5.5, "--trace", "--well", 1.5);
  c.fillStyle = colour("--ink");
  c.font = font("--text-2xs", 600);
  c.textAlign = "center";
  c.fillText(speed > 1e-6 ? `current ${speed.toFixed(2)} m/s` : "no current", x, y + radius + 26);
  c.fillStyle = colour("--ink-2");
  c.fillText(`${scale} m/s`, x, y + radius + 10);
}
