// A canvas as large as its box, sharp on any screen, drawn when there is something new to show.
import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { theme, typeSize } from "../lib/theme";
import { screen } from "../stream/screen";

export type Paint = (context: CanvasRenderingContext2D, width: number, height: number) => void;

interface Props {
  paint: Paint;
  name: string;
  class?: string;
  /** Whether news are worth drawing at this width, px; without it they always are. */
  due?: (width: number) => boolean;
}

export function Canvas({ paint, name, class: look, due }: Props) {
  const element = useRef<HTMLCanvasElement>(null);
  const size = useRef({ width: 0, height: 0 });
  const latest = useRef(paint);
  latest.current = paint;
  const draw = (): void => {
    const canvas = element.current;
    const context = canvas?.getContext("2d");
    const { width, height } = size.current;
    if (!canvas || !context || !width || !height) return;
    const scale = devicePixelRatio || 1;
    const [w, h] = [Math.round(width * scale), Math.round(height * scale)];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.clearRect(0, 0, width, height);
    latest.current(context, width, height);
  };
  useEffect(() => {
    const canvas = element.current;
    if (!canvas) return;
    const observer = new ResizeObserver(([entry]) => {
      if (!entry) return;
      size.current = entry.contentRect;
      draw();
    });
    observer.observe(canvas);
    return () => observer.disconnect();
  }, []);
  // Not useSignalEffect: it draws a picture later than the values beside it, and makes two pictures of one.
  useEffect(() => {
    let drawn = "";
    return effect(() => {
      const look = `${theme.value}${typeSize.value}`;
      void screen.tick;
      if (look === drawn && due && !due(size.current.width)) return;
      drawn = look;
      draw();
    });
  }, []);
  return <canvas ref={element} class={look} role="img" aria-label={name} />;
}
