// The plan in space, beside the plan from above: the same document, selected and edited in either.
import { useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { heldNow } from "../../live/station";
import { depths } from "../charts/charts";
import { plan } from "../fly/forecast";
import { forecast as variant } from "../fly/what_if";
import { onPlanKey } from "../keys";
import { figures, vehicle } from "../map/figures";
import { flownHere } from "../map/flown_here";
import { Surface } from "../map/surface";
import type { Size } from "../map/viewport";
import { name } from "../model/library";
import { dragging, mission, selected } from "../model/plan";
import { gestures, hovered, lens, orbit, showAll, size } from "./gestures";
import { paintSpace } from "./paint";
import type { SpaceScene } from "./scene";
import "./space.css";

const STRETCHES = [1, 3, 10];

function scene(extent: Size): SpaceScene {
  const forecast = plan.forecast.value;
  const seed = plan.picked.value;
  const here = flownHere();
  return {
    view: mission.value,
    lens: lens(),
    size: extent,
    selected: selected.value,
    hovered: hovered.value,
    nominal: forecast?.nominal,
    variant: variant.value?.nominal,
    flights: forecast?.flights ?? [],
    picked: seed === undefined ? undefined : forecast?.flights.find((flight) => flight.seed === seed),
    stale: !plan.current.value || dragging.value,
    held: forecast?.station,
    heldNow: here && heldNow.value,
    vehicle: here && { at: [here.north, here.east, here.depth], heading: here.heading },
    depths: depths.value,
    figures: figures.value,
    length: vehicle.value?.length_m ?? 1,
  };
}

export function Space() {
  const ready = size.value.width > 0;
  const open = name.value;
  useEffect(() => {
    if (ready && open) showAll();
  }, [ready, open]);
  useSignalEffect(() => {
    // A plan that is begun grows out of sight: look again until it has a dock.
    if (!dragging.value && mission.value.legs.length > 0 && !mission.value.dock) showAll();
  });
  const { at, azimuth, elevation, distance } = orbit.value;
  return (
    <div class="plan-water space">
      <Surface
        name="Plan in space"
        scene={scene}
        paint={paintSpace}
        gestures={gestures}
        onKey={onPlanKey}
        onSize={(next) => {
          size.value = next;
        }}
        cursor={hovered.value ? "grab" : "default"}
        describedBy="space-keys"
        frame={[...at, azimuth, elevation, distance].map((number) => number.toFixed(4)).join(" ")}
      />
      <p id="space-keys" class="sr">
        A drag goes round the plan, the wheel comes nearer. A waypoint is dragged at its depth, with Shift up
        and down. Keys are those of the plan from above.
      </p>
      <div class="space-tools">
        <label class="small-text muted" title="Depths are drawn so many times larger">
          Depth ×{" "}
          <select
            class="small"
            aria-label="Depths drawn larger by"
            value={String(orbit.value.stretch)}
            onChange={(event) => {
              orbit.value = { ...orbit.peek(), stretch: Number(event.currentTarget.value) };
            }}
          >
            {STRETCHES.map((times) => (
              <option key={times} value={String(times)}>
                {times}
              </option>
            ))}
          </select>
        </label>
        <button type="button" class="action small" title="The whole plan in view" onClick={showAll}>
          Fit
        </button>
      </div>
    </div>
  );
}
