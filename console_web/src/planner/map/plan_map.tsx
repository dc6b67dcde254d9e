// The plan from above: draw, drag, look around. All of it works by keyboard too (see keys.ts).
import { untracked, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { fixed } from "../../lib/format";
import { theme } from "../../lib/theme";
import { heldNow } from "../../live/station";
import { drawn as charts } from "../charts/charts";
import { come, source } from "../charts/tiles";
import { plan } from "../fly/forecast";
import { forecast as variant } from "../fly/what_if";
import { onPlanKey } from "../keys";
import { earthWords, originOf, toEarth } from "../model/earth";
import { name } from "../model/library";
import { dragging, mission, selected } from "../model/plan";
import { NextStep } from "../next_step";
import { fitSoon, look, showAll, size, sized, viewport } from "./camera";
import { figures } from "./figures";
import { flownHere } from "./flown_here";
import { HeldLegend } from "./held_legend";
import { LazySpace, spaceShown, toggleSpace } from "./lazy_space";
import { box, cursorAt, gestures, hovered } from "./map_gestures";
import { drawn } from "./outline";
import { paintPlan } from "./paint";
import type { Scene } from "./paint/scene";
import { Surface } from "./surface";
import { dockUp, grid, measured, outlining, TOOLS, tool } from "./tools";
import { type Size, zoomed } from "./viewport";
import "./plan_map.css";

function scene(extent: Size): Scene {
  const forecast = plan.forecast.value;
  const picked = plan.picked.value;
  return {
    view: mission.value,
    viewport: viewport.value,
    size: extent,
    selected: selected.value,
    hovered: hovered.value?.thing,
    figures: figures.value,
    nominal: forecast?.nominal,
    flights: forecast?.flights ?? [],
    picked: picked === undefined ? undefined : forecast?.flights.find(({ seed }) => seed === picked),
    variant: variant.value?.nominal,
    held: forecast?.station,
    heldNow: flownHere() ? heldNow.value : undefined,
    stale: !plan.current.value || dragging.value,
    vehicle: flownHere(),
    box: box.value,
    measured: measured.value,
    charts: charts.value,
    theme: theme.value,
    tiles: tilesHere(),
    drawn: drawn.value,
    waving: tool.value === "wave",
    cursor: tool.value === "measure" || drawn.value.length > 0 ? cursorAt.value : undefined,
  };
}

function tilesHere(): Scene["tiles"] {
  const origin = originOf(mission.value.raw);
  const { address = "", attribution = "" } = source.value ?? {};
  if (!origin || !address) return undefined;
  void come.value;
  return { address, attribution, origin };
}

function cursor(): string {
  if (hovered.value && tool.value !== "measure" && !outlining.value)
    return ["split", "side"].includes(hovered.value.kind) ? "copy" : "grab";
  return tool.value === "select" ? "default" : "crosshair";
}

export function PlanMap() {
  const fittedTo = useRef<string | undefined>(undefined);
  const ready = size.value.width > 0;
  const open = name.value;
  useEffect(() => {
    if (!ready || !open || fittedTo.current === open) return;
    fittedTo.current = open;
    fitSoon.value = true;
    showAll();
  }, [ready, open]);
  useSignalEffect(() => {
    if (!fitSoon.value || dragging.value || !plan.current.value || !plan.forecast.value?.nominal) return;
    fitSoon.value = false;
    untracked(showAll);
  });
  const v = viewport.value;
  return (
    <section class="panel plan-map" aria-label="Plan from above">
      <MapTools />
      <div class="plan-waters">
        <div class="plan-water">
          <Surface
            name="Plan from above"
            scene={scene}
            paint={paintPlan}
            gestures={gestures}
            onKey={onPlanKey}
            onSize={sized}
            cursor={cursor()}
            describedBy="plan-keys"
            frame={[v.x, v.y, v.sx, v.turn].map((number) => number.toFixed(5)).join(" ")}
          />
          <HeldLegend />
          <NextStep />
          <Readout />
          <p id="plan-keys" class="sr">
            N and P select the next and previous thing, arrows move it, Page up and down change its depth, W
            adds a waypoint after it, Delete removes it, question mark lists all keys.
          </p>
        </div>
        <LazySpace />
      </div>
    </section>
  );
}

function MapTools() {
  const zoom = (by: number): void => {
    const { width, height } = size.peek();
    look(zoomed(viewport.peek(), size.peek(), width / 2, height / 2, by));
  };
  return (
    <header class="panel-head map-tools">
      <div class="segments tools">
        {TOOLS.map(({ id, name: word, key, about }) => (
          <button
            key={id}
            type="button"
            aria-pressed={tool.value === id}
            title={`${about} (${key})`}
            onClick={() => {
              tool.value = id;
            }}
          >
            {word}
          </button>
        ))}
      </div>
      <label
        class="grid-choice"
        title="What is placed or dragged goes to this grid; hold Alt to place it freely"
      >
        <span class="muted">Snap</span>
        <select
          class="small"
          value={String(grid.value)}
          onChange={(event) => {
            grid.value = Number(event.currentTarget.value);
          }}
        >
          {[0, 0.1, 0.5, 1, 5, 10].map((step) => (
            <option key={step} value={String(step)}>
              {step ? `${step} m` : "off"}
            </option>
          ))}
        </select>
      </label>
      <span class="grow" />
      <button
        type="button"
        class="action small"
        aria-pressed={spaceShown.value}
        title="The plan in space, beside the plan from above"
        onClick={toggleSpace}
      >
        3-D
      </button>
      <button
        type="button"
        class="action small"
        aria-pressed={dockUp.value}
        aria-disabled={!mission.value.dock}
        title={
          mission.value.dock ? "Turn the picture so that the approach points up" : "No dock is placed yet"
        }
        onClick={() => {
          if (!mission.peek().dock) return;
          dockUp.value = !dockUp.peek();
          showAll();
        }}
      >
        {dockUp.value ? "North up" : "Dock up"}
      </button>
      <button type="button" class="action small zoom" aria-label="Zoom out" onClick={() => zoom(1 / 1.4)}>
        −
      </button>
      <button type="button" class="action small zoom" aria-label="Zoom in" onClick={() => zoom(1.4)}>
        +
      </button>
      <button type="button" class="action small" title="The whole plan in view (F)" onClick={showAll}>
        Fit
      </button>
    </header>
  );
}

function Readout() {
  const at = cursorAt.value;
  if (!at) return null;
  const origin = originOf(mission.value.raw);
  return (
    <output class="readout num" aria-label="Pointer">
      {origin && `${earthWords(toEarth(origin, at[0], at[1]))}  `}N {fixed(at[0], 1)} E {fixed(at[1], 1)} m
    </output>
  );
}
