// The legs with length, time and depth rate: rows are selected and moved by keyboard as on the plan.
import { clock, fixed } from "../../lib/format";
import "../../ui/table.css";
import { onPlanKey, step } from "../keys";
import { legFacts } from "../model/geometry";
import { mission, selected } from "../model/plan";

export function LegsTable() {
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
      <tbody>
        {view.legs.map((leg, i) => {
          const thing = `leg:${i}`;
          const on = selected.value.includes(thing);
          return (
            <tr
              key={i}
              aria-selected={on}
              onClick={(event) => {
                selected.value = event.ctrlKey || event.shiftKey ? [...selected.peek(), thing] : [thing];
              }}
            >
              <th scope="row">{i + 1}</th>
              <td class="num">{fixed(facts[i]?.length, 1)}</td>
              <td class="num">{fixed(facts[i]?.heading, 0)}</td>
              <td class="num">{fixed(leg.speed, 2)}</td>
              <td class="num">{fixed(facts[i]?.seconds, 0)}</td>
              <td class="num">{fixed(facts[i]?.depthRate, 3)}</td>
            </tr>
          );
        })}
      </tbody>
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
