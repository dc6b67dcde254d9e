// A canvas as large as its box, sharp on any screen, drawn in animation frames with news.
import { useEffect, useRef } from "preact/hooks";
import { onFrame } from "../stream/frame";

export type Paint = (context: CanvasRenderingContext2D, width: number, height: number) => void;

export function Canvas({ paint, name, class: look }: { paint: Paint; name: string; class?: string }) {
  const element = useRef<HTMLCanvasElement>(null);
  const latest = useRef(paint);
  latest.current = paint;
  useEffect(() => {
    const canvas = element.current;
    const context = canvas?.getContext("2d");
    if (!canvas || !context) return;
    let width = 0;
    let height = 0;
    const draw = (): void => {
      if (!width || !height) return;
      const scale = devicePixelRatio || 1;
      const [w, h] = [Math.round(width * scale), Math.round(height * scale)];
      if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
      context.setTransform(scale, 0, 0, scale, 0, 0);
      context.clearRect(0, 0, width, height);
      latest.current(context, width, height);
    };
    const observer = new ResizeObserver(([entry]) => {
      if (!entry) return;
      ({ width, height } = entry.contentRect);
      draw();
    });
    observer.observe(canvas);
    const stop = onFrame(draw);
    return () => {
      observer.disconnect();
      stop();
    };
  }, []);
  return <canvas ref={element} class={look} role="img" aria-label={name} />;
}
