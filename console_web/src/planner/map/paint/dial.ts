// Current and waves as dials in the corner.
import { colour, font } from "../../../lib/theme";
import { DIAL, type Dial, dialScale, dialTip, WAVES, waveScale, waveTip } from "../grips";
import type { Px } from "../viewport";
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

/** Rings and north of a dial. */
function face(c: Ctx, s: Scene, { x, y, radius }: Dial, on: boolean): void {
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
}

function hand(c: Ctx, { x, y }: Dial, [tx, ty]: Px, ink: string, still: boolean): void {
  c.strokeStyle = colour(ink);
  c.lineWidth = 2.5;
  if (!still) arrow(c, x, y, Math.atan2(ty - y, tx - x), Math.hypot(tx - x, ty - y));
  dot(c, tx, ty, still ? 5.5 : 4, ink, "--well", 1.5);
}

function names(c: Ctx, { x, y, radius }: Dial, words: string, scale: string): void {
  c.fillStyle = colour("--ink");
  c.font = font("--text-2xs", 600);
  c.textAlign = "center";
  c.fillText(words, x, y + radius + 26);
  c.fillStyle = colour("--ink-2");
  c.fillText(scale, x, y + radius + 10);
}

/** The current as a dial in the corner: its arrow is dragged. */
export function paintDial(c: Ctx, s: Scene): void {
  const speed = Math.hypot(s.view.current[0], s.view.current[1]);
  const still = speed <= 1e-6;
  face(c, s, DIAL, s.selected.includes("current"));
  hand(c, DIAL, dialTip(s.view.current, s.viewport), "--trace", still);
  names(
    c,
    DIAL,
    still ? "no current" : `current ${speed.toFixed(2)} m/s`,
    `${dialScale(s.view.current)} m/s`,
  );
}

/** The waves as a dial below it: the way they travel, and how high they are. */
export function paintWaves(c: Ctx, s: Scene): void {
  const wave = s.view.wave ?? { height: 0, period: 0, direction: 0 };
  face(c, s, WAVES, s.selected.includes("wave"));
  hand(c, WAVES, waveTip(wave, s.viewport), "--reference", wave.height === 0);
  const words = wave.height > 0 ? `waves ${wave.height.toFixed(2)} m` : "no waves";
  names(c, WAVES, words, `${waveScale(wave.height)} m`);
}
