// Drawing no faster than eyes need: at once when it has been a while, else once at the end of the pause.

export const DRAW_MS = 95; // about ten pictures a second

export interface Paced {
  (): void;
  /** Now, whatever was drawn when. */
  now: () => void;
  stop: () => void;
}

export function paced(draw: () => void, pauseMs = DRAW_MS): Paced {
  let last = Number.NEGATIVE_INFINITY;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const now = (): void => {
    clearTimeout(timer);
    timer = undefined;
    last = performance.now();
    draw();
  };
  const soon = (): void => {
    const wait = last + pauseMs - performance.now();
    if (wait <= 0) now();
    else timer ??= setTimeout(now, wait);
  };
  return Object.assign(soon, { now, stop: () => clearTimeout(timer) });
}
