// What was changed on this vehicle from here: by whom, why and what; each can be gone back to.
import { useEffect } from "preact/hooks";
import { revisions } from "../api/resources";
import { dateTime } from "../lib/format";
import { live } from "../stream/store";
import { Empty, Panel } from "../ui/panel";
import { draft } from "../weights/draft";
import { flatOfJson } from "../weights/flat";
import "./ahead_panel.css";

const MOST_SHOWN = 6;

export function Revisions() {
  const now = Number(live.latest("tlm/parameters")?.revision ?? 0);
  useEffect(() => void revisions.refresh(), [now]);
  const { value: list, refusal } = revisions;
  return (
    <Panel title="Revisions" class="revisions">
      {refusal && <Empty>They cannot be read: {refusal.reason}</Empty>}
      {list && !list.length && <Empty>Nothing was changed from here yet.</Empty>}
      {list && list.length > 0 && (
        <ol class="revision-list">
          {list.map((made) => {
            const changes = Object.entries(made.changes);
            return (
              <li key={`${made.session}/${made.revision}/${made.at}`}>
                <b class="num">{made.revision}</b>
                <span class="muted num">{dateTime(made.at)}</span>
                <span>{made.author || "no name"}</span>
                <span class="muted">{made.reason || "no reason given"}</span>
                <span class="grow" />
                <button
                  type="button"
                  class="action small"
                  title="Load all that was set then into the draft; nothing is applied yet"
                  onClick={() => draft.load(flatOfJson(made.parameters))}
                >
                  Go back to {made.revision}
                </button>
                <span class="code">
                  {changes
                    .slice(0, MOST_SHOWN)
                    .map(([path, [from, to]]) => `${path} ${told(from)} → ${told(to)}`)
                    .join("; ")}
                  {changes.length > MOST_SHOWN && ` and ${changes.length - MOST_SHOWN} more`}
                </span>
              </li>
            );
          })}
        </ol>
      )}
    </Panel>
  );
}

function told(value: unknown): string {
  const text = JSON.stringify(value) ?? "–";
  return text.length > 40 ? `${text.slice(0, 39)}…` : text;
}
