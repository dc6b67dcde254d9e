// Showing no faster than eyes need: what comes meanwhile is shown with the next picture, and the last never lost.

export const PICTURE_MS = 140; // about seven pictures a second: more cannot be read, and each costs the whole page

type Frame = (run: () => void) => void;

/** Calls `run` in an animation frame, at least `pauseMs` after the one before. */
export function pictures(pauseMs = PICTURE_MS, frame: Frame = (run) => requestAnimationFrame(run)): Frame {
  let last = Number.NEGATIVE_INFINITY;
  return (run) => {
    const draw = (): void =>
      frame(() => {
        last = performance.now();
        run();
      });
    const wait = last + pauseMs - performance.now();
    if (wait > 0) setTimeout(draw, wait);
    else draw();
  };
}
