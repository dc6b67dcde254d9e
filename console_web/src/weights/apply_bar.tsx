// The draft's state and its three actions: undo, revert, apply. What the vehicle answered stays
// in sight until the next edit.

import { barred, tunes } from "../access/control";
import { link } from "../stream/link";
import { live } from "../stream/store";
import { ActButton } from "../ui/act_button";
import { CheckIcon, RedoIcon, UndoIcon, WarningIcon } from "../ui/icons";
import { ProblemTable, RefusalNotice } from "../ui/refusal";
import { draft } from "./draft";
import { isOutside } from "./ranges";
import "./apply_bar.css";

const SLOW_MS = 3000;
const NOTHING = "The draft has no change";
const SENT = "The vehicle has not answered yet";

/** Why the draft can't be applied now; "" when it can. */
function whyNot(changes: number, busy: boolean): string {
  if (busy) return SENT;
  if (!changes) return NOTHING;
  if (draft.invalid.value.size > 0) return "A field holds no number";
  if (link.value.look !== "live") return "No live vehicle to apply it to";
  return tunes.value ? barred.value : "Only an engineer may tune the vehicle";
}

export function ApplyBar() {
  const apply = draft.apply.value;
  const changed = draft.changedPaths.value;
  const outside = changed.filter((path) => {
    const value = draft.value(path);
    return typeof value === "number" && isOutside(path, value);
  }).length;
  const busy = apply.state === "sending" || apply.state === "awaiting";
  return (
    <section class="panel apply" aria-label="Draft">
      <div class="apply-line">
        <span class="apply-state" role="status">
          {changed.length === 0
            ? "The draft equals what the vehicle flies with."
            : `${changed.length} ${changed.length === 1 ? "change" : "changes"} in the draft, not active yet.`}
          {outside > 0 && <span class="lost"> {outside} out of range.</span>}
        </span>
        <Outcome />
        <span class="grow" />
        <ActButton
          class="quiet"
          label="Undo"
          title="Undo (Ctrl+Z)"
          why={draft.canUndo.value ? "" : "Nothing to undo"}
          onAct={() => draft.undo()}
        >
          <UndoIcon />
        </ActButton>
        <ActButton
          class="quiet"
          label="Redo"
          title="Redo (Ctrl+Shift+Z)"
          why={draft.canRedo.value ? "" : "Nothing to redo"}
          onAct={() => draft.redo()}
        >
          <RedoIcon />
        </ActButton>
        <input
          class="apply-reason"
          aria-label="Reason of the change"
          placeholder="Reason, for the record"
          maxLength={300}
          value={draft.reason.value}
          onInput={(event) => {
            draft.reason.value = event.currentTarget.value;
          }}
        />
        <ActButton
          class="action"
          why={changed.length === 0 ? NOTHING : busy ? SENT : ""}
          onAct={() => draft.revertAll()}
        >
          Revert all
        </ActButton>
        <ActButton class="action primary" why={whyNot(changed.length, busy)} onAct={() => void draft.send()}>
          {busy ? "Applying" : "Apply to vehicle"}
        </ActButton>
      </div>
      {draft.outdated.value && !busy && <Outdated />}
      {apply.state === "refused" && (
        <>
          <RefusalNotice
            title="Refused; nothing was changed."
            refusal={apply.refusal}
            onClose={() => draft.dismiss()}
          />
          {apply.refusal.problems.length > 0 && <ProblemTable problems={apply.refusal.problems} />}
        </>
      )}
    </section>
  );
}

/** Somebody changed what the vehicle flies with since: the draft must be looked at again before it is applied. */
function Outdated() {
  const now = live.latest("tlm/parameters")?.revision;
  return (
    <p class="apply-outdated" role="status">
      <WarningIcon /> The draft was made from revision {draft.basis.value}; the vehicle flies revision{" "}
      {String(now ?? "–")}. Applying it would be refused.
      <button type="button" class="action small" onClick={() => draft.rebase()}>
        Keep my changes over revision {String(now ?? "–")}
      </button>
    </p>
  );
}

function Outcome() {
  const apply = draft.apply.value;
  const revision = live.latest("tlm/parameters")?.revision;
  switch (apply.state) {
    case "sending":
      return (
        <span class="chip" data-look="waiting">
          Sent to the vehicle
        </span>
      );
    case "awaiting": {
      const slow = live.now.value - apply.since > SLOW_MS;
      return (
        <span class="chip" data-look={slow ? "stale" : "waiting"}>
          {slow && <WarningIcon />} Accepted, waiting for revision {apply.revision} on the stream
        </span>
      );
    }
    case "confirmed":
      return (
        <span class="chip" data-look="live">
          <CheckIcon /> Confirmed by the vehicle, revision {apply.revision}
        </span>
      );
    case "differs":
      return (
        <span class="chip" data-look="lost" title={apply.paths.join("\n")}>
          <WarningIcon /> The vehicle flies other values in {apply.paths.length} field(s)
        </span>
      );
    default:
      return revision === undefined ? null : (
        <span class="muted">
          Active: revision <span class="num">{String(revision)}</span>
        </span>
      );
  }
}
