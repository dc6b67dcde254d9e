// Below the command line on every view: what went wrong stays here until a person has seen it.
import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { heldByOther, NOT_YOURS } from "../access/control";
import type { Alarm } from "../gen/bumpless_pb";
import { timeOfDay, zoneName } from "../lib/zone";
import { ActButton } from "../ui/act_button";
import { CheckIcon, ClockIcon } from "../ui/icons";
import { useKeptFocus } from "../ui/keep_focus";
import "./alarm_bar.css";
import { AlarmHistory } from "./alarm_history";
import {
  type AlarmState,
  acknowledge,
  alarms,
  refused,
  shelve,
  stateOf,
  unseen,
  whole,
  worst,
} from "./alarms";
import { lookOf } from "./looks";

const SHELVES: [seconds: number, name: string][] = [
  [300, "5 min"],
  [600, "10 min"],
  [1800, "30 min"],
  [3600, "1 h"],
  [28_800, "8 h"],
];
const FIRST_SHELF_S = 600;
const STATES: Record<AlarmState, string> = {
  unacknowledged: "holds",
  acknowledged: "seen, holds",
  returned: "over, not seen",
  shelved: "shelved",
};

function barLook(): string {
  if (worst.value <= 2) return "alarm";
  return worst.value <= 5 ? "warning" : "seen";
}

export function AlarmBar() {
  const bar = useRef<HTMLElement>(null);
  useKeptFocus(bar);
  const all = alarms.value;
  if (!all.length && !whole.value) return null;
  const first = unseen.value[0];
  const shown = whole.value ? all : first ? [first] : [];
  const more = all.length - shown.length;
  return (
    <section class="alarms" aria-label="Alarms" ref={bar} data-look={barLook()}>
      <ol aria-live="assertive">
        {shown.map((alarm) => (
          <Row key={alarm.id} alarm={alarm} />
        ))}
        {!shown.length && (
          <li class="alarm-row muted">
            {all.length ? `Alarms that were seen and still hold: ${all.length}` : "No alarm is open."}
          </li>
        )}
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
      {whole.value && <AlarmHistory />}
    </section>
  );
}

const at = (ns: bigint): Date => new Date(Number(ns / 1_000_000n));

/** Who has seen it or put it aside, and when. */
function handled(alarm: Alarm, state: AlarmState): string {
  const told = (ns: bigint): string => `${timeOfDay(at(ns))} ${zoneName(at(ns))}`;
  const by = alarm.details.shelved_by ? ` by ${alarm.details.shelved_by}` : "";
  if (state === "shelved") return `shelved${by} until ${told(alarm.shelvedUntilNs)}`;
  if (alarm.acknowledgedNs) return `seen by ${alarm.acknowledgedBy} at ${told(alarm.acknowledgedNs)}, holds`;
  return STATES[state];
}

function Row({ alarm }: { alarm: Alarm }) {
  const state = stateOf(alarm, Date.now());
  const { name, look, Icon } = lookOf(alarm);
  const about = [alarm.code, ...Object.entries(alarm.details).map(([key, value]) => `${key}: ${value}`)];
  return (
    <li class="alarm-row" data-look={look} data-alarm={state} title={about.join("\n")}>
      <span class="alarm-mark" data-look={look}>
        <Icon size={16} />
        <span class="sr">{name}</span>
      </span>
      <time class="num">
        {timeOfDay(at(alarm.raisedNs))} {zoneName(at(alarm.raisedNs))}
      </time>
      <span class="alarm-text">
        {alarm.text}
        {alarm.count > 1 && ` (${alarm.count} times)`}
      </span>
      <span class="tag">{handled(alarm, state)}</span>
      {!alarm.acknowledgedNs && (
        <ActButton
          class="action small"
          why={heldByOther.value ? NOT_YOURS : ""}
          onAct={() => void acknowledge(alarm)}
        >
          <CheckIcon size={12} /> Seen<span class="sr">: {alarm.text}</span>
        </ActButton>
      )}
      {state !== "shelved" && !alarm.returnedNs && <Shelve alarm={alarm} />}
    </li>
  );
}

function Shelve({ alarm }: { alarm: Alarm }) {
  const seconds = useSignal(FIRST_SHELF_S);
  return (
    <span class="shelve">
      <ActButton
        class="action small"
        why={heldByOther.value ? NOT_YOURS : ""}
        title="Keep it out of the way for a time; it comes back by itself"
        onAct={() => void shelve(alarm, seconds.value)}
      >
        <ClockIcon size={12} /> Shelve<span class="sr">: {alarm.text}</span>
      </ActButton>
      <select
        class="small"
        aria-label={`Shelve for, ${alarm.text}`}
        value={seconds.value}
        onChange={(event) => {
          seconds.value = Number(event.currentTarget.value);
        }}
      >
        {SHELVES.map(([value, name]) => (
          <option key={value} value={value}>
            {name}
          </option>
        ))}
      </select>
    </span>
  );
}
