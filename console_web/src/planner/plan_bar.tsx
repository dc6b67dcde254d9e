// The planner's top line: which mission, how it stands to file and vehicle, undo and redo, save and start.
import { useSignal } from "@preact/signals";
import { ask } from "../api/client";
import { bytes } from "../lib/format";
import { ActButton } from "../ui/act_button";
import { CheckIcon, CrossIcon, HollowIcon, PlayIcon, RedoIcon, UndoIcon, WarningIcon } from "../ui/icons";
import { RefusalNotice } from "../ui/refusal";
import { hard } from "./fly/forecast";
import { vehicle } from "./map/figures";
import {
  type Badge,
  badge,
  builtin,
  done,
  duplicate,
  hash,
  name,
  remove,
  rename,
  revert,
  save,
  saving,
  stored,
  trouble,
  unkept,
  unsaved,
} from "./model/library";
import { mission, redo, redoLabel, text, undo, undoLabel } from "./model/plan";
import { preflight } from "./preflight_state";
import { versionsOpen } from "./versions";
import "./plan_bar.css";

const BADGES: Record<Badge, { words: string; look: string; about: string }> = {
  new: { words: "Not saved", look: "stale", about: "Only in this browser so far" },
  changed: {
    words: "Not saved",
    look: "stale",
    about: "It differs from the stored file; the draft is kept in this browser",
  },
  elsewhere: {
    words: "Changed by somebody else",
    look: "lost",
    about: "The stored file changed since you began",
  },
  saved: { words: "Saved, not on the vehicle", look: "off", about: "The vehicle holds no mission" },
  held: { words: "Saved, on the vehicle", look: "live", about: "The vehicle holds this very text" },
  other: { words: "Saved, the vehicle holds another one", look: "off", about: "By the hash of its bytes" },
};

export function PlanBar({ open, onOpen }: { open: boolean; onOpen: () => void }) {
  return (
    <>
      <div class="plan-bar" role="group" aria-label="Plan">
        <button type="button" class="action" aria-expanded={open} onClick={onOpen}>
          {name.value ? "Open" : "Missions"} …
        </button>
        {name.value && <Named />}
        <span class="grow" />
        {name.value && <Actions />}
      </div>
      <Notices />
    </>
  );
}

function Named() {
  const look = BADGES[badge.value];
  const own = vehicle.value;
  return (
    <>
      <span class="plan-name">
        <b class="ellipsis">{mission.value.title || name.value}</b>
        <Rename />
      </span>
      <span
        class="chip"
        data-look={look.look}
        role="status"
        aria-label="How it is kept"
        title={`${look.about}\n${hash.value.slice(0, 12)}, ${bytes(text.value.length)}`}
      >
        {look.look === "live" ? (
          <CheckIcon size={11} />
        ) : look.look === "off" ? (
          <HollowIcon size={11} />
        ) : (
          <WarningIcon size={11} />
        )}{" "}
        {look.words}
      </span>
      {unkept.value && (
        <span
          class="chip"
          data-look="stale"
          title="This browser keeps nothing: save, or it is lost with the page"
        >
          <WarningIcon size={11} /> draft not kept
        </span>
      )}
      {own && <span class="muted ellipsis plan-vehicle">{own.name}</span>}
    </>
  );
}

function Rename() {
  const typed = useSignal<string | undefined>(undefined);
  const dirty = stored.value !== undefined && unsaved.value;
  const bad = typed.value !== undefined && !/^[A-Za-z0-9][A-Za-z0-9_-]{0,63}$/.test(typed.value);
  if (typed.value === undefined)
    return (
      <ActButton
        class="link code muted"
        why={
          builtin.value
            ? "It comes with Bumpless and keeps its name"
            : dirty
              ? "Save before you rename it"
              : ""
        }
        title="Rename"
        onAct={() => {
          typed.value = name.peek();
        }}
      >
        {name.value}
      </ActButton>
    );
  const finish = async (): Promise<void> => {
    const to = typed.peek();
    if (to === undefined || bad || (await rename(to))) typed.value = undefined;
  };
  return (
    <input
      class="rename"
      aria-label="Name of the mission"
      aria-invalid={bad}
      title="Letters, digits, - and _; at most 64"
      ref={(box) => box?.focus()}
      value={typed.value}
      onInput={(event) => {
        typed.value = event.currentTarget.value;
      }}
      onKeyDown={(event) => {
        if (event.key === "Enter") void finish();
        if (event.key === "Escape") typed.value = undefined;
      }}
      onBlur={() => void finish()}
    />
  );
}

/** Why there is nothing to save now; "" when there is. */
function whyNotSaved(): string {
  if (saving.value) return "It is being saved";
  if (unsaved.value) return "";
  return builtin.value ? "It comes with Bumpless and stays: an edit makes a copy" : "It is saved as it is";
}

function Actions() {
  return (
    <>
      <ActButton
        class="quiet"
        label="Undo"
        why={undoLabel.value === undefined ? "Nothing to undo" : ""}
        title={`Undo: ${undoLabel.value} (Ctrl+Z)`}
        onAct={undo}
      >
        <UndoIcon size={16} />
      </ActButton>
      <ActButton
        class="quiet"
        label="Redo"
        why={redoLabel.value === undefined ? "Nothing to redo" : ""}
        title={`Redo: ${redoLabel.value} (Ctrl+Y)`}
        onAct={redo}
      >
        <RedoIcon size={16} />
      </ActButton>
      <More />
      <ActButton class="action" why={whyNotSaved()} title="Ctrl+S" onAct={() => void save()}>
        {saving.value ? "Saving" : "Save"}
      </ActButton>
      <button
        type="button"
        class="action primary"
        title={hard.value.length ? "It can't work yet: the sheet says why" : "The sheet before the start"}
        onClick={() => {
          preflight.value = true;
        }}
      >
        <PlayIcon /> Start …
      </button>
    </>
  );
}

const COMES = "It comes with Bumpless and stays as it is";

function More() {
  const open = useSignal(false);
  const run = (act: () => void) => () => {
    open.value = false;
    act();
  };
  const lose = (event: FocusEvent): void => {
    if (!(event.currentTarget as HTMLElement).contains(event.relatedTarget as Node | null))
      open.value = false;
  };
  return (
    <div class="more" onFocusOut={lose}>
      <button
        type="button"
        class="action"
        aria-expanded={open.value}
        onClick={() => {
          open.value = !open.peek();
        }}
      >
        More
      </button>
      {open.value && (
        <div class="more-list">
          <button type="button" onClick={run(duplicate)}>
            Duplicate
          </button>
          <ActButton
            class=""
            why={stored.value && unsaved.value ? "" : "There is no change since it was saved"}
            onAct={run(() => void revert())}
          >
            Discard changes
          </ActButton>
          <ActButton
            class=""
            why={builtin.value ? COMES : stored.value ? "" : "It has not been saved yet"}
            onAct={run(() => {
              versionsOpen.value = true;
            })}
          >
            Earlier versions …
          </ActButton>
          <button type="button" onClick={run(() => give(text.peek(), `${name.peek()}.yaml`))}>
            Download YAML
          </button>
          {FORMATS.map(({ to, words }) => (
            <button key={to} type="button" onClick={run(() => void exportAs(to))}>
              Download {words}
            </button>
          ))}
          <ActButton class="" why={builtin.value ? COMES : ""} onAct={run(() => void remove())}>
            Delete
          </ActButton>
        </div>
      )}
    </div>
  );
}

const FORMATS = [
  { to: "plan", words: "QGroundControl .plan" },
  { to: "geojson", words: "GeoJSON" },
  { to: "kml", words: "KML" },
  { to: "csv", words: "CSV" },
] as const;

function give(content: string, file: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content]));
  link.download = file;
  link.click();
  URL.revokeObjectURL(link.href);
}

async function exportAs(to: (typeof FORMATS)[number]["to"]): Promise<void> {
  const answer = await ask("post", "/api/missions/export", { query: { to }, body: new Blob([text.peek()]) });
  trouble.value = answer.ok ? undefined : answer;
  if (!answer.ok) return;
  const { file_name, text: content, items } = answer.value;
  give(content, file_name);
  const lost = items.filter(({ carried }) => !carried).map(({ what, note }) => `${what}: ${note}`);
  done.value = {
    text: lost.length ? `Downloaded. Not carried over: ${lost.join("; ")}` : "Downloaded, all of it.",
  };
}

function Notices() {
  return (
    <>
      {trouble.value && !preflight.value && (
        <RefusalNotice
          title="That did not work."
          refusal={trouble.value}
          onClose={() => {
            trouble.value = undefined;
          }}
        />
      )}
      {badge.value === "elsewhere" && (
        <div class="plan-notice" role="alert">
          <WarningIcon size={16} />
          <span class="grow">The stored file was changed since you began. Saving would replace it.</span>
          <button type="button" class="action small" onClick={() => void revert()}>
            Take the stored one
          </button>
          <button type="button" class="action small" onClick={() => void save(true)}>
            Replace it
          </button>
        </div>
      )}
      {done.value && (
        <div class="plan-notice" role="status">
          <span class="grow">{done.value.text}</span>
          {done.value.undo && (
            <button
              type="button"
              class="action small"
              onClick={() => {
                const undoIt = done.peek()?.undo;
                done.value = undefined;
                undoIt?.();
              }}
            >
              Undo
            </button>
          )}
          <button
            type="button"
            class="quiet"
            aria-label="Dismiss"
            onClick={() => {
              done.value = undefined;
            }}
          >
            <CrossIcon />
          </button>
        </div>
      )}
    </>
  );
}
