// What the rings round the dock say, in words.
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { flowWords, HELD_ZONES, type Held, type HeldZone, headingsOf, heldWord } from "../../lib/held";
import { heldNow, watchStation } from "../../live/station";
import { plan } from "../fly/forecast";
import { dragging } from "../model/plan";
import { flownHere } from "./flown_here";
import "./held_legend.css";

/** Folded where it would cover much of the plan; it says then what holds, all the same. */
const open = signal(matchMedia("(min-width: 1200px)").matches);

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
      data-fresh={fresh ? "yes" : "no"}
      open={open.value}
      onToggle={(event) => {
        open.value = event.currentTarget.open;
      }}
    >
      <summary title="Round the dock: a heading is drawn where the hull lies with it, its bow to the dock">
        Holds station <span class="num">{headingsOf(planned, "accepted") || "nowhere surely"}</span>
      </summary>
      <p class="num">Planned: {flowWords(planned.current_ned_mps)}</p>
      <ul>
        {HELD_ZONES.map(({ zone, word }) => (
          <Zone key={zone} zone={zone} word={word} held={planned} />
        ))}
      </ul>
      {planned.reason && (
        <p class="held-why">
          Its own heading {heldWord(planned.zone)}: {planned.reason}
        </p>
      )}
      {felt && (
        <p class="num" data-zone={felt.zone}>
          Now, outer ring: {flowWords(felt.current_ned_mps)}, {heldWord(felt.zone)}
          {felt.zone === "accepted" ? "" : `: ${felt.reason}`}
        </p>
      )}
    </details>
  );
}

/** The refused are all others, where there are others. */
function Zone({ zone, word, held }: { zone: HeldZone; word: string; held: Held }) {
  const headings = headingsOf(held, zone);
  if (!headings) return null;
  const others = zone === "refused" && headings !== "any heading";
  return (
    <li data-zone={zone}>
      <i aria-hidden="true" />
      <span>{word}</span>
      <span class="num" title={headings}>
        {others ? "the others" : headings}
      </span>
    </li>
  );
}
