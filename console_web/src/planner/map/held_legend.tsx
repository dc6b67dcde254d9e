// What the rings round the dock say, in words.
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { flowWords, HELD_ZONES, type Held, headingsOf, heldWord } from "../../lib/held";
import { heldNow, watchStation } from "../../live/station";
import { plan } from "../fly/forecast";
import { dragging } from "../model/plan";
import { flownHere } from "./flown_here";
import "./held_legend.css";

const open = signal(true);

export function HeldLegend() {
  useEffect(watchStation, []);
  const planned = plan.forecast.value?.station;
  const felt = flownHere() ? heldNow.value : undefined;
  if (!planned) return null;
  const fresh = plan.current.value && !dragging.value;
  return (
    <details
      class="held-legend"
      aria-label="Headings that hold station"
      open={open.value}
      onToggle={(event) => {
        open.value = event.currentTarget.open;
      }}
    >
      <summary title="Round the dock: a heading is drawn where the hull lies with it, its bow to the dock">
        Headings that hold station
      </summary>
      <div data-fresh={fresh ? "yes" : "no"}>
        <Zones title={`Planned: ${flowWords(planned.current_ned_mps)}`} held={planned} />
      </div>
      {felt && <Zones title={`Estimated now (outer ring): ${flowWords(felt.current_ned_mps)}`} held={felt} />}
    </details>
  );
}

function Zones({ title, held }: { title: string; held: Held }) {
  return (
    <section aria-label={title}>
      <p class="num">{title}</p>
      <ul>
        {HELD_ZONES.map(({ zone, word }) => {
          const headings = headingsOf(held, zone);
          if (!headings) return null;
          return (
            <li key={zone} data-zone={zone}>
              <i aria-hidden="true" />
              <span>{word}</span> <span class="num">{headings}</span>
            </li>
          );
        })}
      </ul>
      {held.zone !== "accepted" && (
        <p class="held-why" title={held.reason}>
          {heldWord(held.zone)} its own: {held.reason}
        </p>
      )}
    </section>
  );
}
