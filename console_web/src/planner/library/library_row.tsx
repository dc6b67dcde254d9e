// One mission of the list: open it, copy it, tag it, put it away.

import { useSignal } from "@preact/signals";
import { ask } from "../../api/client";
import { missions } from "../../api/resources";
import { clock } from "../../lib/format";
import { go } from "../../shell/address";
import { foreign, present } from "../../stream/present";
import { ActButton } from "../../ui/act_button";
import { fromTemplate, name, trouble } from "../model/library";
import type { Entry } from "./entries";

const LONGEST_TAG = 40;

export function Row({ entry, onClose }: { entry: Entry; onClose: () => void }) {
  const other = foreign(entry);
  const open = useSignal(false);
  return (
    <li class="library-entry" data-foreign={other ? "yes" : undefined}>
      <div class="library-row">
        <button
          type="button"
          class="library-open"
          aria-current={entry.name === name.value ? "true" : undefined}
          title={other ? `It is for ${entry.vehicle}; on the bus is ${present.value}` : undefined}
          onClick={() => {
            go("plan", entry.name);
            onClose();
          }}
        >
          <span class="row-title">
            <b class="ellipsis">{entry.title}</b>
            {entry.draft && <span class="tag">draft</span>}
            {!entry.valid && <span class="tag">breaks a rule</span>}
            {other && <span class="tag">for {entry.vehicle}</span>}
            {entry.tags.map((tag) => (
              <span key={tag} class="tag own">
                {tag}
              </span>
            ))}
            <span class="grow" />
            {entry.duration !== null && <span class="muted num">{clock(entry.duration)}</span>}
          </span>
          <span class="muted library-about">{entry.about}</span>
        </button>
        {entry.builtin && (
          <button
            type="button"
            class="action small"
            title="A mission of your own that begins as this one"
            aria-label={`New from ${entry.title}`}
            onClick={() => {
              void fromTemplate(entry.name);
              onClose();
            }}
          >
            New from it
          </button>
        )}
        {entry.stored && (
          <button
            type="button"
            class="action small"
            aria-expanded={open.value}
            aria-label={`More of ${entry.title}`}
            onClick={() => {
              open.value = !open.peek();
            }}
          >
            …
          </button>
        )}
      </div>
      {open.value && <Marks entry={entry} onClose={onClose} />}
    </li>
  );
}

async function mark(of: string, body: { tags?: string[]; archived?: boolean }): Promise<void> {
  const answer = await ask("put", "/api/missions/{name}/marks", { path: { name: of }, body });
  trouble.value = answer.ok ? undefined : answer;
  await missions.refresh();
}

function Marks({ entry, onClose }: { entry: Entry; onClose: () => void }) {
  const typed = useSignal(entry.tags.join(", "));
  const tags = typed.value
    .split(",")
    .map((tag) => tag.trim().slice(0, LONGEST_TAG))
    .filter(Boolean);
  const changed = tags.join() !== entry.tags.join();
  const keep = (): void => {
    if (changed) void mark(entry.name, { tags });
  };
  return (
    <div class="library-marks">
      <label>
        <span class="muted">Tags</span>
        <input
          aria-label={`Tags of ${entry.title}`}
          placeholder="harbour, trials"
          value={typed.value}
          onInput={(event) => {
            typed.value = event.currentTarget.value;
          }}
          onKeyDown={(event) => event.key === "Enter" && keep()}
        />
      </label>
      <ActButton class="action small" why={changed ? "" : "The tags are as they are kept"} onAct={keep}>
        Keep tags
      </ActButton>
      {!entry.builtin && (
        <button
          type="button"
          class="action small"
          onClick={() => {
            void fromTemplate(entry.name);
            onClose();
          }}
        >
          Duplicate
        </button>
      )}
      <button
        type="button"
        class="action small"
        title="Out of the list; no byte of it changes"
        onClick={() => void mark(entry.name, { archived: !entry.archived })}
      >
        {entry.archived ? "Take out of the archive" : "Put into the archive"}
      </button>
    </div>
  );
}
