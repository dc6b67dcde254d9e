// One requestAnimationFrame for the whole page: whoever draws is called at most once per
// frame, and only when something changed. Four times a second it fires for ages alone.
import { useEffect, useReducer } from "preact/hooks";

type Draw = () => void;
const draws = new Set<Draw>();
let requested = false;

function run(): void {
  requested = false;
  for (const draw of draws) draw();
}

/** Ask for a redraw in the next animation frame. */
export function invalidate(): void {
  if (requested) return;
  requested = true;
  requestAnimationFrame(run);
}

/** Call `draw` in each animation frame in which there is news; returns the way to stop. */
export function onFrame(draw: Draw): () => void {
  draws.add(draw);
  return () => draws.delete(draw);
}

/** Render the calling component again whenever there is news. */
export function useFrame(): void {
  const [, render] = useReducer((count: number) => count + 1, 0);
  useEffect(() => onFrame(() => render(undefined as never)), []);
}

const AGE_TICK_MS = 250;
export function startAgeTick(): void {
  setInterval(invalidate, AGE_TICK_MS);
}
