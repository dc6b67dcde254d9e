// What happened, newest first; severity by shape and colour.
import { useSignal } from "@preact/signals";
import { type Event, Severity } from "../gen/bumpless_pb";
import { clock } from "../lib/format";
import { timeOfDay, zoneName } from "../lib/zone";
import { screen } from "../stream/screen";
import { live } from "../stream/store";
import { whenMs } from "../stream/vehicle_time";
import { AlarmIcon, InfoIcon, WarningIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import { Segments } from "../ui/segments";
import "./event_panel.css";
import { SwitchFacts } from "./switch_facts";

const LOOKS: Record<Severity, { look: string; name: string; Icon: typeof InfoIcon }> = {
  [Severity.UNSPECIFIED]: { look: "info", name: "Note", Icon: InfoIcon },
  [Severity.INFO]: { look: "info", name: "Information", Icon: InfoIcon },
  [Severity.WARNING]: { look: "warning", name: "Warning", Icon: WarningIcon },
  [Severity.ALARM]: { look: "alarm", name: "Alarm", Icon: AlarmIcon },
};
const FILTERS = [
  { name: "All", value: Severity.UNSPECIFIED },
  { name: "Warnings", value: Severity.WARNING },
  { name: "Alarms", value: Severity.ALARM },
];
const SHOWN = 120;

export function EventPanel() {
  const least = useSignal<Severity>(Severity.UNSPECIFIED);
  return (
    <Panel
      title="Events"
      class="event-panel"
      aside={
        <Segments
          name="Least severity"
          choices={FILTERS}
          chosen={least.value}
          onChoose={(next) => {
            least.value = next;
          }}
        />
      }
    >
      <List least={least.value} />
    </Panel>
  );
}

function List({ least }: { least: Severity }) {
  const events = screen.events.filter((event) => event.severity >= least).slice(0, SHOWN);
  if (!events.length) {
    return (
      <Empty>
        {screen.events.length
          ? "Nothing of this severity."
          : "Mode switches, warnings and commands are noted here."}
      </Empty>
    );
  }
  return (
    <div class="events" role="log" aria-label="Event log, newest first" tabIndex={0}>
      <ol>
        {events.map((event) => (
          <Row key={`${event.stamp?.timeNs}${event.code}${event.text}`} event={event} />
        ))}
      </ol>
    </div>
  );
}

function Row({ event }: { event: Event }) {
  const { look, name, Icon } = LOOKS[event.severity];
  const details = Object.entries(event.details).map(([key, value]) => `${key}: ${value}`);
  return (
    <li class="event" data-look={look} title={[event.code, ...details].join("\n")}>
      <span class="event-icon">
        <Icon />
        <span class="sr">{name}</span>
      </span>
      <time class="num">{when(event)}</time>
      {event.code === "mode_switch" ? <Switch event={event} /> : <span class="event-text">{event.text}</span>}
    </li>
  );
}

/** A past switch opens to what was true, what would have prevented it, and what it cost. */
function Switch({ event }: { event: Event }) {
  const open = useSignal(false);
  return (
    <details
      class="event-text"
      onToggle={(toggled) => {
        open.value = toggled.currentTarget.open;
      }}
    >
      <summary>{event.text}</summary>
      {open.value && <SwitchFacts event={event} />}
    </details>
  );
}

/** Mission time where there is one, else the time of day. */
function when(event: Event): string {
  if (event.stamp && (event.stamp.missionTimeS > 0 || !screen.isLive))
    return `T+${clock(event.stamp.missionTimeS)}`;
  const ms = whenMs(event, live.latest("server/status")?.clockOffsetS ?? 0);
  if (ms === undefined) return "";
  const at = new Date(ms);
  return `${timeOfDay(at)} ${zoneName(at)}`;
}
