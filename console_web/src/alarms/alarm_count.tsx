// In the bar on every view: how many alarms of each priority are open, and whether new ones are heard.
import { BellIcon, BellOffIcon, CheckIcon } from "../ui/icons";
import "./alarm_count.css";
import { alarms, whole } from "./alarms";
import { lookOf, priorityOf } from "./looks";
import { heard, setHeard } from "./sound";

export function AlarmCount() {
  const counts = new Map<number, number>();
  for (const alarm of alarms.value) counts.set(priorityOf(alarm), (counts.get(priorityOf(alarm)) ?? 0) + 1);
  const sorted = [...counts].sort(([a], [b]) => a - b);
  return (
    <span class="alarm-count" role="group" aria-label="Alarms by priority">
      <button
        type="button"
        class="quiet small alarm-counts"
        title="All alarms, and those that are over"
        aria-expanded={whole.value}
        onClick={() => {
          whole.value = !whole.value;
        }}
      >
        {sorted.length === 0 && (
          <span>
            <CheckIcon size={12} /> <span class="sr">No alarm</span>0
          </span>
        )}
        {sorted.map(([priority, count]) => {
          const { name, look, Icon } = lookOf({ priority, severity: 0 });
          return (
            <span key={priority} data-look={look} title={`${name}: ${count}`}>
              <Icon size={12} />
              <span class="sr">{name} </span>
              <span class="num">{count}</span>
            </span>
          );
        })}
      </button>
      <button
        type="button"
        class="quiet small"
        aria-pressed={heard.value}
        aria-label="Sound of new alarms"
        title={
          heard.value
            ? "New alarms are heard; press for silence"
            : "New alarms are silent; press to hear them"
        }
        onClick={() => setHeard(!heard.value)}
      >
        {heard.value ? <BellIcon /> : <BellOffIcon />}
      </button>
    </span>
  );
}
