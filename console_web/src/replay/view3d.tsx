// Flights in 3-D on a plain canvas: the report's own view, in the console's colours.
import { effect, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import {
  type Data3d,
  type Hull3d,
  type Look3d,
  type Preset3d,
  View3d,
} from "../../../twin/bumpless/review/replay3d.js";
import { ask } from "../api/client";
import { MODES } from "../gen/house";
import { colour, font, theme, typeSize } from "../lib/theme";
import { Panel } from "../ui/panel";
import { Segments } from "../ui/segments";
import "./view3d.css";

const VIEWS = [
  { value: "follow", name: "Follow", about: "Behind the vehicle" },
  { value: "overview", name: "Overview", about: "Whole way and target" },
  { value: "top", name: "Top", about: "From above, north up" },
] as const satisfies readonly { value: Preset3d; name: string; about: string }[];

const hulls = signal<ReadonlyMap<string, Hull3d>>(new Map());

/** The hull of a run's vehicle; asked for once. */
export function hullOf(run: string): Hull3d | undefined {
  return hulls.value.get(run);
}

export async function learnHull(run: string): Promise<void> {
  if (hulls.peek().has(run)) return;
  const answer = await ask("get", "/api/runs/{run}/hull", { path: { run } });
  if (answer.ok) hulls.value = new Map(hulls.peek()).set(run, answer.value);
}

function look(): Look3d {
  return {
    ground: colour("--well"),
    grid: colour("--grid"),
    ink: colour("--ink"),
    faint: colour("--line-2"),
    path: colour("--ink-2"),
    target: colour("--reference"),
    hull: "#e6b93c",
    font: font("--text-xs"),
    modes: Object.fromEntries(MODES.map((mode) => [mode.letter, mode.colour])),
  };
}

interface Props {
  title: string;
  preset: Preset3d;
  class?: string;
  /** What is shown; read again whenever a signal in it changes. */
  data: () => Data3d;
  /** The moment that is shown, s. */
  time: () => number;
}

export function Scene3d({ title, preset, class: name, data, time }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const view = useRef<View3d | undefined>(undefined);
  const chosen = useRef(signal<Preset3d>(preset)).current;
  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    const shown = new View3d(element, { flights: [] }, look());
    view.current = shown;
    const stopLooking = effect(() => {
      void [theme.value, typeSize.value];
      shown.look = look();
      const first = shown.data.flights.length === 0;
      shown.data = data();
      if (first) shown.view(chosen.peek());
      else shown.draw(shown.time);
    });
    const stopAiming = effect(() => shown.view(chosen.value));
    const stopMoving = effect(() => shown.draw(time()));
    const size = new ResizeObserver(() => shown.draw(shown.time));
    size.observe(element);
    return () => {
      size.disconnect();
      stopLooking();
      stopAiming();
      stopMoving();
    };
  }, []);
  return (
    <Panel
      title={title}
      unit="NED"
      class={`view3d ${name ?? ""}`}
      aside={
        <Segments
          name="Camera"
          choices={VIEWS}
          chosen={chosen.value}
          onChoose={(next) => {
            chosen.value = next;
          }}
        />
      }
    >
      <canvas
        ref={canvas}
        tabIndex={0}
        role="img"
        aria-label={`${title}; drag or arrow keys turn it, wheel or plus and minus zoom`}
      />
    </Panel>
  );
}
