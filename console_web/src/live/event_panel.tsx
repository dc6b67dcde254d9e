// What happened, newest first; severity by shape and colour.
import { useState } from "preact/hooks";
import { Severity, type Event } from "../gen/bumpless_pb";
import { clock } from "../lib/format";
import { useFrame } from "../stream/frame";
import { live } from "../stream/store";
import { AlarmIcon, InfoIcon, WarningIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";

const LOOKS: Record<Severity, { look: string; name: string; Icon: typeof InfoIcon }> = {
  [Severity.UNSPECIFIED]: { look: "info", name: "Note", Icon: InfoIcon },
  [Severity.INFO]: { look: "info", name: "Information", Icon: InfoIcon },
  [Severity.WARNING]: { look: "warning", name: "Warning", Icon: WarningIcon },
  [Severity.ALARM]: { look: "alarm", name: "Alarm", Icon: AlarmIcon },
};
const FILTERS = [
  { name: "All", least: Severity.UNSPECIFIED },
  { name: "Warnings", least: Severity.WARNING },
  { name: "Alarms", least: Severity.ALARM },
];
const SHOWN = 120;

export function EventPanel() {
  const [least, setLeast] = useState<Severity>(Severity.UNSPECIFIED);
  return (
    <Panel
      title="Events"
      class="event-panel"
      aside={
        <div class="segments" role="group" aria-label="Least severity">
          {FILTERS.map((filter) => (
            <button key={filter.name} type="button" aria-pressed={least === filter.least} onClick={() => setLeast(filter.least)}>
              {filter.name}
            </button>
          ))}
        </div>
      }
    >
      <List least={least} />
    </Panel>
  );
}

function List({ least }: { least: Severity }) {
  useFrame();
  const events = live.events.filter((event) => event.severity >= least).slice(0, SHOWN);
  if (!events.length) {
    return <Empty>{live.events.length ? "Nothing of this severity." : "Mode switches, warnings and commands are noted here."}</Empty>;
  }
  return (
    <div class="events" role="log" aria-label="Event log, newest first" tabIndex={0}>
      <ol>
        {events.map((event) => <Row key={`${event.stamp?.timeNs}${event.code}${event.text}`} event={event} />)}
      </ol>
    </div>
  );
}

function Row({ event }: { event: Event }) {
  const { look, name, Icon } = LOOKS[event.severity];
  const details = Object.entries(event.details).map(([key, value]) => `${key}: ${value}`);
  return (
    <li class="event" data-look={look} title={[event.code, ...details].join("\n")}>
      <span class="event-icon"><Icon /><span class="sr">{name}</span></span>
      <time class="num">{when(event)}</time>
      <span class="event-text">{event.text}</span>
    </li>
  );
}

/** Mission time where there is one, else the time of day. */
function when(event: Event): string {
  if (event.stamp && event.stamp.missionTimeS > 0) return `T+${clock(event.stamp.missionTimeS)}`;
  if (!event.stamp?.timeNs) return "";
  return new Date(Number(event.stamp.timeNs / 1_000_000n)).toTimeString().slice(0, 8);
}
