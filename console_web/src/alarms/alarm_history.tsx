// The alarms that are over, newest first: raised, gone, seen by whom.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { ask } from "../api/client";
import type { components } from "../gen/api";
import { dateTime } from "../lib/format";
import { alarms } from "./alarms";

type Over = components["schemas"]["Alarm"];
const SHOWN = 30;
const SECOND_NS = 1e9;

export function AlarmHistory() {
  const over = useSignal<Over[]>([]);
  const trouble = useSignal("");
  const open = alarms.value.map(({ id }) => id).join();
  useEffect(() => {
    void ask("get", "/api/alarms").then((answer) => {
      if (answer.ok) over.value = answer.value.history.slice(0, SHOWN);
      trouble.value = answer.ok ? "" : answer.reason;
    });
  }, [open]);
  const when = (ns: string): string => dateTime(Number(ns) / SECOND_NS);
  return (
    <div class="alarm-history">
      <h2>Over</h2>
      {trouble.value && <p class="lost">{trouble.value}</p>}
      {!over.value.length && !trouble.value && <p class="muted">None yet.</p>}
      <ol aria-label="Alarms that are over">
        {over.value.map((alarm) => (
          <li key={alarm.id}>
            <time class="num">{when(alarm.raised_ns)}</time> {alarm.text}{" "}
            <span class="muted">
              seen by {alarm.acknowledged_by || "nobody"} at {when(alarm.acknowledged_ns)}
            </span>
          </li>
        ))}
      </ol>
    </div>
  );
}
