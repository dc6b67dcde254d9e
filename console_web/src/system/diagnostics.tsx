// Nothing silent: each kind of what was not taken as it came, the age of each topic, and files left out.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { age, dateTime, fixed } from "../lib/format";
import { live } from "../stream/store";
import { WarningIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import { diagnostics } from "./resources";

export function Diagnostics() {
  const counted = live.latest("server/status")?.setAside;
  useEffect(() => void diagnostics.refresh(), [counted]);
  const { value: told, refusal } = diagnostics;
  const all = useSignal(false);
  if (refusal && !told) return <Empty>The diagnostics cannot be read: {refusal.reason}</Empty>;
  if (!told) return null;
  const happened = told.counted.filter(({ count }) => count > 0);
  const shown = all.value ? told.counted : happened;
  return (
    <>
      <Panel
        title="Not taken as it came"
        class="system-wide"
        scrolls
        aside={
          <>
            <label class="check">
              <input
                type="checkbox"
                checked={all.value}
                onChange={(event) => {
                  all.value = event.currentTarget.checked;
                }}
              />{" "}
              all kinds
            </label>
            <button type="button" class="action small" onClick={() => void diagnostics.refresh()}>
              Refresh
            </button>
          </>
        }
      >
        <Notices notices={[told.bus_notice, told.audit_trouble]} />
        {shown.length === 0 && <Empty>Everything was taken as it came since the server's start.</Empty>}
        {shown.length > 0 && (
          <table class="table compact">
            <thead>
              <tr>
                <th scope="col" class="num">
                  Count
                </th>
                <th scope="col">What it means</th>
                <th scope="col">Last</th>
                <th scope="col">Last example</th>
              </tr>
            </thead>
            <tbody>
              {shown.map((one) => (
                <tr key={one.kind}>
                  <td class="num">{one.count}</td>
                  <th scope="row" class="wraps">
                    {one.meaning}
                  </th>
                  <td class="when">{one.last ? dateTime(one.last) : "never"}</td>
                  <td class="code wraps">{one.example}</td>
                </tr>
              ))}
            </tbody>
          </table>
        )}
      </Panel>
      <Panel title="Topics" scrolls>
        <table class="table compact">
          <thead>
            <tr>
              <th scope="col">Topic</th>
              <th scope="col" class="num">
                Age
              </th>
              <th scope="col" class="num">
                Late after
              </th>
              <th scope="col">State</th>
            </tr>
          </thead>
          <tbody>
            {told.topics.map((topic) => (
              <tr key={topic.topic}>
                <th scope="row" class="code">
                  {topic.topic}
                </th>
                <td class="num">{topic.age_s === null ? "–" : age(topic.age_s)}</td>
                <td class="num">{fixed(topic.fresh_for_s, 1)} s</td>
                <td>
                  {topic.age_s === null ? (
                    <span class="muted">not yet</span>
                  ) : topic.late ? (
                    <span class="lost">late</span>
                  ) : (
                    "present"
                  )}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </Panel>
      <Panel title="Clock, session and files" scrolls>
        <dl class="facts">
          <div>
            <dt>Vehicle's clock minus the server's</dt>
            <dd class="num">{fixed(told.clock_offset_s, 3)} s</dd>
          </div>
          <div>
            <dt>Session that speaks for the vehicle</dt>
            <dd class="code">{told.vehicle_session || "it tells none"}</dd>
          </div>
        </dl>
        {told.left_out.length === 0 ? (
          <Empty>Every file in the data folder stands in its list.</Empty>
        ) : (
          <table class="table compact" aria-label="Files left out">
            <thead>
              <tr>
                <th scope="col">Left out</th>
                <th scope="col">Reason</th>
              </tr>
            </thead>
            <tbody>
              {told.left_out.map((one) => (
                <tr key={`${one.folder}/${one.name}`}>
                  <th scope="row" class="code wraps">
                    {one.folder}/{one.name}
                  </th>
                  <td class="wraps">{one.reason}</td>
                </tr>
              ))}
            </tbody>
          </table>
        )}
      </Panel>
    </>
  );
}

function Notices({ notices }: { notices: string[] }) {
  return (
    <>
      {notices.filter(Boolean).map((notice) => (
        <p key={notice} class="system-notice" role="status">
          <WarningIcon size={16} /> {notice}
        </p>
      ))}
    </>
  );
}
