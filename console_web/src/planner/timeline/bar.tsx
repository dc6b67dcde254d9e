// One fault or outage as a bar: dragged as a whole or by an end, moved by the arrow keys.
import { useRef } from "preact/hooks";
import type { EventKind } from "../model/event_kinds";
import { type Edge, eventEdits, nudgeEvent } from "../model/events";
import { snapped } from "../model/geometry";
import type { PlanEvent } from "../model/mission";
import { deleteSelected } from "../model/operations";
import { drag, drop, letGo, selected } from "../model/plan";
import { lasts, share } from "./scale";

const STEP_S = 0.5;
const FINE_S = 0.1;
const EDGE_PX = 8;
const EDGE_TOUCH_PX = 18;
const CLICK_PX = 3;

interface Pull {
  edge: Edge;
  /** Pointer's place and the event's begin (or end) when it was pressed. */
  x: number;
  at: number;
  perPx: number;
  moved: boolean;
}

interface BarProps {
  kind: EventKind;
  index: number;
  event: PlanEvent;
  name: string;
}

export function Bar({ kind, index, event, name }: BarProps) {
  const pull = useRef<Pull | undefined>(undefined);
  const thing = `${kind}:${index}`;
  const down = (pointer: PointerEvent): void => {
    if (pointer.button > 0) return;
    const bar = pointer.currentTarget as HTMLElement;
    const box = bar.getBoundingClientRect();
    const water = bar.parentElement?.getBoundingClientRect().width || 1;
    bar.setPointerCapture(pointer.pointerId);
    const edge = edgeAt(pointer, box, event.to === undefined);
    selected.value = [thing];
    const at = edge === "to" ? (event.to ?? event.from) : event.from;
    pull.current = { edge, x: pointer.clientX, at, perPx: lasts.peek() / water, moved: false };
  };
  const move = (pointer: PointerEvent): void => {
    const held = pull.current;
    if (!held) return;
    const by = pointer.clientX - held.x;
    held.moved ||= Math.abs(by) > CLICK_PX;
    if (!held.moved) return;
    const to = snapped(held.at + by * held.perPx, pointer.altKey ? FINE_S : STEP_S);
    drag((view) => eventEdits(view, thing, held.edge, Math.min(to, lasts.peek())));
  };
  const up = (cancelled: boolean): void => {
    if (pull.current?.moved) {
      if (cancelled) letGo();
      else drop("Change a time");
    }
    pull.current = undefined;
  };
  return (
    <button
      type="button"
      class="event-bar"
      data-kind={kind}
      data-open={event.to === undefined ? "yes" : undefined}
      aria-label={name}
      aria-pressed={selected.value.includes(thing)}
      title={`${name}\nArrows move it by 1 s (Shift: 10 s), with Alt its end; Delete removes it`}
      style={{ left: share(event.from), width: share((event.to ?? lasts.value) - event.from) }}
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={() => up(false)}
      onPointerCancel={() => up(true)}
      onClick={() => {
        selected.value = [thing];
      }}
      onKeyDown={(key) => onKey(key, thing)}
    >
      {kind === "fault" && <span class="num">{(100 * event.left).toFixed(0)} %</span>}
    </button>
  );
}

function edgeAt(pointer: PointerEvent, box: DOMRect, open: boolean): Edge {
  const reach = Math.min(pointer.pointerType === "touch" ? EDGE_TOUCH_PX : EDGE_PX, box.width / 3);
  if (open || pointer.clientX - box.left < reach) return "from";
  return box.right - pointer.clientX < reach ? "to" : "both";
}

function onKey(event: KeyboardEvent, thing: string): void {
  const way = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
  if (way !== 0) nudgeEvent(thing, event.altKey ? "to" : "both", way * (event.shiftKey ? 10 : 1));
  else if (event.key === "Delete" || event.key === "Backspace") {
    selected.value = [thing];
    deleteSelected();
  } else return;
  event.preventDefault();
}
