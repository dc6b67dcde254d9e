// A canvas that fills its box, is drawn once per frame when a signal it shows changes, and hands gestures on.
import { untracked, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { theme, typeSize } from "../../lib/theme";
import type { Size } from "./viewport";

export interface Press {
  x: number;
  y: number;
  touch: boolean;
  /** Shift, Ctrl or Cmd: add to the selection, or don't snap. */
  shift: boolean;
  many: boolean;
  alt: boolean;
  /** Middle or right button. */
  other: boolean;
}

export interface Gestures {
  /** What moving from here does; undefined: nothing was taken hold of. */
  press(at: Press): void;
  move(at: Press, pressed: boolean): void;
  release(at: Press, cancelled: boolean): void;
  wheel(at: Press, by: number): void;
  pinch(at: Press, by: number, dx: number, dy: number): void;
  leave(): void;
}

interface SurfaceProps<Scene> {
  name: string;
  /** What is to be drawn: reads every signal that it shows. */
  scene: (size: Size) => Scene;
  paint: (c: CanvasRenderingContext2D, scene: Scene) => void;
  gestures: Gestures;
  onKey: (event: KeyboardEvent) => void;
  onSize: (size: Size) => void;
  cursor: string;
  describedBy?: string;
  /** For tests and scripts: how metres lie on the canvas. */
  frame?: string;
}

export function Surface<Scene>(props: SurfaceProps<Scene>) {
  const { name, cursor, describedBy, frame, onKey } = props;
  const element = useRef<HTMLCanvasElement>(null);
  const size = useRef<Size>({ width: 0, height: 0 });
  const asked = useRef(0);
  const latest = useRef(props);
  latest.current = props;
  const touches = useRef(new Map<number, { x: number; y: number }>());

  const draw = (): void => {
    const canvas = element.current;
    const c = canvas?.getContext("2d");
    const { width, height } = size.current;
    if (!canvas || !c || !width || !height) return;
    const scale = devicePixelRatio || 1;
    const [w, h] = [Math.round(width * scale), Math.round(height * scale)];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    c.setTransform(scale, 0, 0, scale, 0, 0);
    c.clearRect(0, 0, width, height);
    latest.current.paint(
      c,
      untracked(() => latest.current.scene(size.current)),
    );
  };
  useEffect(() => {
    const canvas = element.current;
    if (!canvas) return;
    const observer = new ResizeObserver(([entry]) => {
      if (!entry) return;
      const { width, height } = entry.contentRect;
      size.current = { width, height };
      latest.current.onSize(size.current);
      draw();
    });
    observer.observe(canvas);
    const wheel = (event: WheelEvent): void => {
      event.preventDefault();
      latest.current.gestures.wheel(pressOf(event), event.deltaY);
    };
    canvas.addEventListener("wheel", wheel, { passive: false });
    return () => {
      observer.disconnect();
      canvas.removeEventListener("wheel", wheel);
      cancelAnimationFrame(asked.current);
    };
  }, []);
  // Whatever the scene reads is read here, so that a change of it asks for a frame.
  useSignalEffect(() => {
    void [theme.value, typeSize.value];
    latest.current.scene(size.current);
    cancelAnimationFrame(asked.current);
    asked.current = requestAnimationFrame(draw);
  });

  const pressOf = (event: PointerEvent | WheelEvent | MouseEvent): Press => {
    const box = element.current?.getBoundingClientRect();
    return {
      x: event.clientX - (box?.left ?? 0),
      y: event.clientY - (box?.top ?? 0),
      touch: "pointerType" in event && event.pointerType === "touch",
      shift: event.shiftKey,
      many: event.shiftKey || event.ctrlKey || event.metaKey,
      alt: event.altKey,
      other: event.button === 1 || event.button === 2,
    };
  };
  const down = (event: PointerEvent): void => {
    element.current?.setPointerCapture(event.pointerId);
    element.current?.parentElement?.focus({ preventScroll: true });
    const at = pressOf(event);
    if (at.touch) touches.current.set(event.pointerId, at);
    if (touches.current.size > 1) latest.current.gestures.release(at, true);
    else latest.current.gestures.press(at);
  };
  const move = (event: PointerEvent): void => {
    const at = pressOf(event);
    const before = touches.current.get(event.pointerId);
    if (before && touches.current.size === 2) {
      const other = [...touches.current].find(([id]) => id !== event.pointerId)?.[1];
      if (other) {
        const was = Math.hypot(before.x - other.x, before.y - other.y);
        const is = Math.hypot(at.x - other.x, at.y - other.y);
        const middle = { ...at, x: (at.x + other.x) / 2, y: (at.y + other.y) / 2 };
        latest.current.gestures.pinch(
          middle,
          is / Math.max(1, was),
          (at.x - before.x) / 2,
          (at.y - before.y) / 2,
        );
      }
      touches.current.set(event.pointerId, at);
      return;
    }
    if (before) touches.current.set(event.pointerId, at);
    latest.current.gestures.move(at, event.buttons !== 0);
  };
  const up = (event: PointerEvent, cancelled: boolean): void => {
    const several = touches.current.size > 1;
    touches.current.delete(event.pointerId);
    if (!several) latest.current.gestures.release(pressOf(event), cancelled);
  };
  return (
    <div
      class="surface"
      role="application"
      tabIndex={0}
      aria-label={name}
      aria-describedby={describedBy}
      onKeyDown={onKey}
    >
      <canvas
        ref={element}
        data-frame={frame}
        style={{ cursor }}
        onPointerDown={down}
        onPointerMove={move}
        onPointerUp={(event) => up(event, false)}
        onPointerCancel={(event) => up(event, true)}
        onPointerLeave={() => latest.current.gestures.leave()}
        onContextMenu={(event) => event.preventDefault()}
      />
    </div>
  );
}
