// The plots: one group at a time, or the operator's own choice, all on the same time window and cursor.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import "uplot/dist/uPlot.min.css";
import { heldAt, screen } from "../stream/screen";
import { PauseIcon, PlayIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import { Segments } from "../ui/segments";
import { Plot } from "./plot";
import { GROUPS } from "./plots";
import "./plot_panel.css";
import { watchReach } from "./reach";
import { ScrubBar } from "./scrub_bar";
import { SignalChooser } from "./signal_chooser";
import { group, shownSpecs } from "./signals";
import { follow, hold, scrub, zoom } from "./time_axis";

const CHOICES = GROUPS.map((name) => ({ value: name, name }));

const KEYS: Record<string, (far: boolean) => void> = {
  " ": () => (Number.isNaN(heldAt.peek()) ? hold() : follow()),
  ArrowLeft: (far) => scrub(far ? -1 : -0.1),
  ArrowRight: (far) => scrub(far ? 1 : 0.1),
  "+": () => zoom(-1),
  "=": () => zoom(-1),
  "-": () => zoom(1),
  End: follow,
};

export function PlotPanel() {
  const choosing = useSignal(false);
  useEffect(watchReach, []);
  const choice = (
    <>
      <Segments
        name="Plot group"
        choices={CHOICES}
        chosen={group.value}
        onChoose={(next) => {
          group.value = next;
        }}
      />
      <button
        type="button"
        class="quiet small"
        aria-label="Choose signals, layouts and a run to compare with"
        title="Choose signals, layouts and a run to compare with"
        aria-expanded={choosing.value}
        onClick={() => {
          choosing.value = !choosing.value;
        }}
      >
        …
      </button>
      {screen.isLive && <HoldTime />}
    </>
  );
  return (
    <Panel title="Plots" topic="tlm/navigation" class="plot-panel" aside={choice}>
      {choosing.value && (
        <SignalChooser
          onClose={() => {
            choosing.value = false;
          }}
        />
      )}
      <Plots />
      {screen.isLive && <ScrubBar />}
    </Panel>
  );
}

function HoldTime() {
  const held = !Number.isNaN(heldAt.value);
  return (
    <button
      type="button"
      class="quiet small"
      aria-label={held ? "Follow the present" : "Hold the plots"}
      title={held ? "Follow the present" : "Hold the plots; what comes is still taken in"}
      aria-pressed={held}
      onClick={held ? follow : hold}
    >
      {held ? <PlayIcon size={12} /> : <PauseIcon size={12} />}
    </button>
  );
}

function press(event: KeyboardEvent): void {
  const act = KEYS[event.key];
  if (!act || !screen.isLive || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  act(event.shiftKey);
}

function Plots() {
  if (!screen.latest("tlm/navigation")) return <Empty>Plots begin with the first telemetry.</Empty>;
  const specs = shownSpecs.value;
  if (!specs.length) return <Empty>No signal is chosen, or this vehicle has none of them.</Empty>;
  return (
    <section
      class="plots"
      data-many={specs.length > 4 ? "yes" : undefined}
      aria-label="Plots over time; arrows move through it, Space holds"
      tabIndex={0}
      onKeyDown={press}
    >
      {specs.map((spec, index) => (
        <Plot key={spec.id} spec={spec} axis={index === specs.length - 1 || specs.length > 4} />
      ))}
    </section>
  );
}
