// One line over the water: what to do next, so that nobody has to read a manual first.
import { flying } from "../stream/link";
import { PlayIcon } from "../ui/icons";
import { hard, plan, soft } from "./fly/forecast";
import { mend } from "./fly/mend";
import { closeOutline, drawn } from "./map/outline";
import { outlining, tool } from "./map/tools";
import { name, unsaved } from "./model/library";
import { nextIndex } from "./model/operations";
import { broken, dragging, mission, selected } from "./model/plan";
import { FEWEST_CORNERS } from "./model/zones";
import { preflight } from "./preflight_state";
import "./next_step.css";

export function NextStep() {
  if (!name.value || broken.value || dragging.value) return null;
  const view = mission.value;
  const free = nextIndex(view);
  if (tool.value === "measure") return <Hint>Click two or more points. Escape ends.</Hint>;
  if (outlining.value) return <Outlining />;
  if (tool.value === "wave")
    return <Hint>Drag on the water the way the waves travel; farther is higher.</Hint>;
  if (tool.value === "current")
    return <Hint>Drag on the water the way the current flows: 42 px are the dial's radius.</Hint>;
  if (tool.value === "dock")
    return <Hint>Press where the dock is, and drag the way the vehicle shall point when it docks.</Hint>;
  if (free === 0) return <Hint>Click on the water: each click is a waypoint.</Hint>;
  if (!view.dock)
    return (
      <Hint>
        {tool.value === "waypoint" ? "Go on clicking for more waypoints, then" : "Now"}
        <button
          type="button"
          class="action small primary"
          onClick={() => {
            tool.value = "dock";
          }}
        >
          Place the dock
        </button>
      </Hint>
    );
  return <Judged />;
}

function Outlining() {
  const count = drawn.value.length;
  const words =
    count === 0
      ? "Click corner by corner, or drag a rectangle."
      : count < FEWEST_CORNERS
        ? "Go on: an outline has three corners or more."
        : "The first corner again, Enter or here:";
  return (
    <Hint>
      {words}
      {count >= FEWEST_CORNERS && (
        <button type="button" class="action small primary" onClick={closeOutline}>
          Close it
        </button>
      )}
    </Hint>
  );
}

function Judged() {
  const forecast = plan.forecast.value;
  if (!plan.current.value || !forecast) return null;
  const [first] = hard.value;
  if (first) {
    const [best] = first.mends;
    return (
      <div class="next-step" data-look="poor" role="status" aria-label="Next step">
        <span>This can't work as it is.</span>
        {best && (
          <button type="button" class="action small primary" onClick={() => mend(best)}>
            {best.label}
          </button>
        )}
      </div>
    );
  }
  if (forecast.state !== "done" || !forecast.chance || forecast.problems.length > 0) return null;
  const share = forecast.chance.docked / Math.max(1, forecast.chance.of);
  if (flying.value) return null; // what is next is up to the vehicle
  if (share < 0.95) return <Doubtful docked={forecast.chance.docked} of={forecast.chance.of} />;
  return (
    <div class="next-step" data-look="good" role="status" aria-label="Next step">
      <span>This will dock.</span>
      <button
        type="button"
        class="action small primary"
        onClick={() => {
          selected.value = [];
          preflight.value = true;
        }}
      >
        <PlayIcon /> {unsaved.value ? "Save and start" : "Start"} …
      </button>
    </div>
  );
}

/** What most often keeps a plan that can be flown from docking, in the order in which it is worth mending. */
const COSTS_CHANCE = [
  "hover_to_the_end",
  "current_may_differ",
  "current_hard_to_hold",
  "long_hover",
  "short_of_time",
];

function Doubtful({ docked, of }: { docked: number; of: number }) {
  const worth = (code: string) =>
    (COSTS_CHANCE.indexOf(code) + COSTS_CHANCE.length + 1) % (COSTS_CHANCE.length + 1);
  const [first] = soft.value
    .filter((finding) => finding.mends.length > 0)
    .sort((a, b) => worth(a.code) - worth(b.code));
  const best = first?.mends[0];
  if (!best) return null;
  return (
    <div class="next-step" data-look="fair" role="status" aria-label="Next step">
      <span title={first.reason}>
        Docks in <span class="num">{docked}</span> of <span class="num">{of}</span>. What would help:
      </span>
      <button type="button" class="action small primary" onClick={() => mend(best)}>
        {best.label}
      </button>
    </div>
  );
}

function Hint({ children }: { children: preact.ComponentChildren }) {
  return (
    <div class="next-step" role="status" aria-label="Next step">
      {children}
    </div>
  );
}
