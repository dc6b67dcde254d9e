// How far past the present the flights ahead reach.
import { screen } from "../stream/screen";
import { reach } from "./flights";

/** Seconds past the present that the plots show for the flights ahead; 0 without any, and in a replay. */
export function room(): number {
  if (!screen.isLive || screen.until < screen.history.last()) return 0; // or the plots are held in the past
  const left = reach() - screen.history.last();
  return Number.isFinite(left) ? Math.max(left, 0) : 0;
}
