// Where nothing has been flown yet: three ways to begin. The example comes with captions as it happens.
import { signal } from "@preact/signals";
import { barred } from "../access/control";
import { missions } from "../api/resources";
import { MissionPhase, Mode } from "../gen/bumpless_pb";
import { go } from "../shell/address";
import { chosen, startShown, waits } from "../shell/commands";
import { flying, link, phase } from "../stream/link";
import { ownFirst } from "../stream/present";
import { screen, shownMode } from "../stream/screen";
import { ActButton } from "../ui/act_button";
import { CrossIcon, PlayIcon } from "../ui/icons";
import "./first_steps.css";

const EXAMPLE = "docking";
/** The example was started here and its captions are wanted. */
const guided = signal(false);
const closed = signal(false);

export function FirstSteps() {
  if (guided.value) return <Captions />;
  const idle = phase.value === MissionPhase.IDLE || phase.value === MissionPhase.UNSPECIFIED;
  if (!idle || closed.value || Number.isFinite(screen.history.missionStart)) return null;
  return <Cards />;
}

function Cards() {
  const list = ownFirst(missions.value ?? []);
  const example = list.find(({ name }) => name === EXAMPLE) ?? list[0];
  const why =
    (link.value.look === "live" ? "" : "No live vehicle") ||
    (example ? "" : "The missions have not come yet") ||
    waits.value ||
    barred.value;
  const fly = async (): Promise<void> => {
    if (!example) return;
    chosen.value = example.name;
    guided.value = await startShown(example);
  };
  return (
    <section class="first-steps" aria-label="First steps">
      <article>
        <h2>Fly the example</h2>
        <p>{example?.title || "A docking flight"}, with a caption for what happens.</p>
        <ActButton class="action primary" why={why} onAct={() => void fly()}>
          <PlayIcon /> Fly it
        </ActButton>
      </article>
      <article>
        <h2>Plan your own</h2>
        <p>Draw a way to a dock; it is flown ahead as you draw.</p>
        <button type="button" class="action" onClick={() => go("plan")}>
          Open the planner
        </button>
      </article>
      <article>
        <h2>Open a log</h2>
        <p>See a recorded flight again, moment by moment.</p>
        <button type="button" class="action" onClick={() => go("runs")}>
          Show the runs
        </button>
      </article>
      <button
        type="button"
        class="quiet small"
        aria-label="Close the first steps"
        onClick={() => {
          closed.value = true;
          document.querySelector<HTMLElement>("main:not([hidden])")?.focus();
        }}
      >
        <CrossIcon size={12} />
      </button>
    </section>
  );
}

const MODES: Partial<Record<Mode, string>> = {
  [Mode.FORWARD]:
    "Forward: it cruises along the path. Fins steer; the screw drives. The range to the dock shrinks in the Mode panel.",
  [Mode.REVERSE]:
    "Reverse: the range has passed F→R, so it brakes. Fins lose their grip as the flow dies; watch their weight fade while κ grows to 1.",
  [Mode.HOVER]:
    "Hover: at the observation point the thrusters hold it. That no actuator jumped at the switch is what this software is for.",
};

function caption(): string {
  switch (phase.value) {
    case MissionPhase.RUNNING:
      return MODES[shownMode.value] ?? "The mission begins.";
    case MissionPhase.PAUSED:
      return "On hold: it keeps station where it was, the mission waits.";
    case MissionPhase.COMPLETED:
      return "Over. It holds station and is still recorded; open it under Runs and press Replay to see it again.";
    case MissionPhase.ABORTED:
      return "Aborted: all actuators stop, it drifts and rises where it is buoyant.";
    default:
      return flying.value ? "The mission begins." : "Waiting for the vehicle to begin.";
  }
}

function Captions() {
  return (
    <section class="captions" aria-label="What happens">
      <p role="status">{caption()}</p>
      <button
        type="button"
        class="quiet small"
        aria-label="Close the captions"
        onClick={() => {
          guided.value = false;
          closed.value = true;
          document.querySelector<HTMLElement>("main:not([hidden])")?.focus();
        }}
      >
        <CrossIcon size={12} />
      </button>
    </section>
  );
}
