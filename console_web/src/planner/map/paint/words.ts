// Words on a canvas.
import { colour, font } from "../../../lib/theme";

/** Text that stays legible over lines. */
export function text(
  c: CanvasRenderingContext2D,
  words: string,
  x: number,
  y: number,
  ink: string,
  weight = 400,
  { size = "--text-xs", align = "left" as CanvasTextAlign } = {},
): void {
  c.font = font(size, weight);
  c.textAlign = align;
  c.lineWidth = 3;
  c.lineJoin = "round";
  c.strokeStyle = colour("--well");
  c.strokeText(words, x, y);
  c.fillStyle = colour(ink);
  c.fillText(words, x, y);
}
