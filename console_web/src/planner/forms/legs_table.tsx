// The legs with length, time and depth rate: rows are selected and moved by keyboard as on the plan.
import type { VNode } from "preact";
import { useRef } from "preact/hooks";
import { clock, fixed } from "../../lib/format";
import "../../ui/table.css";
import { onPlanKey, step } from "../keys";
import { type LegFacts, legFacts } from "../model/geometry";
import { mission, selected } from "../model/plan";

/** Rows as they were drawn last, each with what it shows: of many legs a drag changes two. */
type Kept = Map<number, { shows: string; row: VNode }>;

function row(
  kept: Kept,
  i: number,
  speed: number,
  facts: LegFacts | undefined,
  chosen: readonly string[],
): VNode {
  const thing = `leg:${i}`;
  const on = chosen.includes(thing);
  const cells = [
    fixed(facts?.length, 1),
    fixed(facts?.heading, 0),
    fixed(speed, 2),
    fixed(facts?.seconds, 0),
    fixed(facts?.depthRate, 3),
  ];
  const shows = `${on} ${cells.join()}`;
  const before = kept.get(i);
  if (before?.shows === shows) return before.row;
  const made = (
    <tr
      key={i}
      aria-selected={on}
      onClick={(event) => {
        selected.value = event.ctrlKey || event.shiftKey ? [...selected.peek(), thing] : [thing];
      }}
    >
      <th scope="row">{i + 1}</th>
      {cells.map((cell, k) => (
        <td key={k} class="num">
          {cell}
        </td>
      ))}
    </tr>
  );
  kept.set(i, { shows, row: made });
  return made;
}

export function LegsTable() {
  const kept = useRef<Kept>(new Map());
  const view = mission.value;
  const facts = legFacts(view.start.at, view.legs);
  const total = facts.at(-1)?.end ?? 0;
  const seconds = facts.reduce((sum, leg) => sum + (leg.seconds ?? 0), 0);
  if (view.legs.length === 0)
    return <p class="empty">No waypoints yet. Take the waypoint tool and click on the water.</p>;
  const onKey = (event: KeyboardEvent): void => {
    if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      step(event.key === "ArrowDown" ? 1 : -1);
    } else onPlanKey(event);
  };
  return (
    <table class="table compact legs" aria-label="Legs" tabIndex={0} onKeyDown={onKey}>
      <thead>
        <tr>
          <th scope="col">
            Leg <span class="unit" />
          </th>
          <th scope="col" class="num">
            Length <span class="unit">m</span>
          </th>
          <th scope="col" class="num">
            Course <span class="unit">°</span>
          </th>
          <th scope="col" class="num">
            Speed <span class="unit">m/s</span>
          </th>
          <th scope="col" class="num">
            Time <span class="unit">s</span>
          </th>
          <th scope="col" class="num">
            Dive <span class="unit">m/s</span>
          </th>
        </tr>
      </thead>
      <tbody>{view.legs.map((leg, i) => row(kept.current, i, leg.speed, facts[i], selected.value))}</tbody>
      <tfoot>
        <tr>
          <th scope="row">All</th>
          <td class="num">{fixed(total, 1)}</td>
          <td colSpan={2} />
          <td class="num" title={`The mission ends after ${clock(view.duration)} at the latest`}>
            {fixed(seconds, 0)}
          </td>
          <td />
        </tr>
      </tfoot>
    </table>
  );
}
