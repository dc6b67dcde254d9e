// Below the command line on every view: what went wrong stays here until a person has seen it.
import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { type Alarm, Severity } from "../gen/bumpless_pb";
import { timeOfDay, zoneName } from "../lib/zone";
import { AlarmIcon, CheckIcon, ClockIcon, WarningIcon } from "../ui/icons";
import { useKeptFocus } from "../ui/keep_focus";
import "./alarm_bar.css";
import { type AlarmState, acknowledge, alarms, refused, shelve, stateOf, unseen, worst } from "./alarms";

const SHELF_S = 600;
const STATES: Record<AlarmState, string> = {
  unacknowledged: "holds",
  acknowledged: "seen, holds",
  returned: "over, not seen",
  shelved: "shelved",
};

export function AlarmBar() {
  const whole = useSignal(false);
  const bar = useRef<HTMLElement>(null);
  useKeptFocus(bar);
  const all = alarms.value;
  if (!all.length) return null;
  const first = unseen.value[0];
  const shown = whole.value ? all : first ? [first] : [];
  const more = all.length - shown.length;
  return (
    <section
      class="alarms"
      aria-label="Alarms"
      ref={bar}
      data-look={worst.value >= Severity.ALARM ? "alarm" : worst.value ? "warning" : "seen"}
    >
      <ol aria-live="assertive">
        {shown.map((alarm) => (
          <Row key={alarm.id} alarm={alarm} />
        ))}
        {!shown.length && <li class="alarm-row muted">Alarms that were seen and still hold: {all.length}</li>}
      </ol>
      {(more > 0 || whole.value) && (
        <button
          type="button"
          class="action small"
          aria-expanded={whole.value}
          onClick={() => {
            whole.value = !whole.value;
          }}
        >
          {whole.value ? "Fewer" : `${more} more`}
        </button>
      )}
      {refused.value && (
        <span class="alarm-refused" role="alert">
          {refused.value.reason}
        </span>
      )}
    </section>
  );
}

function Row({ alarm }: { alarm: Alarm }) {
  const state = stateOf(alarm, Date.now());
  const at = new Date(Number(alarm.raisedNs / 1_000_000n));
  const Icon = alarm.severity >= Severity.ALARM ? AlarmIcon : WarningIcon;
  const about = [alarm.code, ...Object.entries(alarm.details).map(([key, value]) => `${key}: ${value}`)];
  return (
    <li
      class="alarm-row"
      data-look={alarm.severity >= Severity.ALARM ? "alarm" : "warning"}
      data-alarm={state}
      title={about.join("\n")}
    >
      <Icon size={16} />
      <span class="sr">{alarm.severity >= Severity.ALARM ? "Alarm" : "Warning"}</span>
      <time class="num">
        {timeOfDay(at)} {zoneName(at)}
      </time>
      <span class="alarm-text">
        {alarm.text}
        {alarm.count > 1 && ` (${alarm.count} times)`}
      </span>
      <span class="tag">{STATES[state]}</span>
      {!alarm.acknowledgedNs && (
        <button type="button" class="action small" onClick={() => void acknowledge(alarm)}>
          <CheckIcon size={12} /> Seen<span class="sr">: {alarm.text}</span>
        </button>
      )}
      {state !== "shelved" && !alarm.returnedNs && (
        <button
          type="button"
          class="action small"
          title={`Keep it out of the way for ${SHELF_S / 60} minutes`}
          onClick={() => void shelve(alarm, SHELF_S)}
        >
          <ClockIcon size={12} /> Shelve<span class="sr">: {alarm.text}</span>
        </button>
      )}
    </li>
  );
}
