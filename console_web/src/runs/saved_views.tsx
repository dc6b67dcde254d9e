// Views of the list that all who use this server share: choose one, keep what is shown as one, forget one.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Refusal } from "../api/http";
import { ActButton } from "../ui/act_button";
import { CrossIcon, UndoIcon } from "../ui/icons";
import { RefusalIn } from "../ui/refusal";
import { ALL, COLUMNS } from "./columns";
import {
  columns,
  forgetView,
  isUsual,
  keepView,
  type RunView,
  runViews,
  show,
  shownView,
  takeViewBack,
  toggle,
  undone,
} from "./list_state";

/** A button with the name of what is shown; under it views and columns. */
export function SavedViews() {
  const open = useSignal(false);
  const button = useRef<HTMLButtonElement>(null);
  const close = (): void => {
    open.value = false;
    button.current?.focus();
  };
  const named = shownView.value?.name ?? (isUsual.value ? "all runs" : "not saved");
  return (
    <div class="views">
      <button
        ref={button}
        type="button"
        class="action small"
        aria-expanded={open.value}
        title="Saved views, and which columns are shown"
        onClick={() => {
          open.value = !open.value;
        }}
      >
        View: <span class="ellipsis">{named}</span>
      </button>
      {open.value && <Menu onClose={close} />}
    </div>
  );
}

function Menu({ onClose }: { onClose: () => void }) {
  const refusal = useSignal<Refusal | undefined>(undefined);
  const name = useSignal(shownView.value?.name ?? "");
  const panel = useRef<HTMLDivElement>(null);
  useEffect(() => {
    void runViews.refresh();
    panel.current?.querySelector("button")?.focus();
    const outside = (event: PointerEvent): void => {
      const at = event.target as Node;
      if (!panel.current?.parentElement?.contains(at)) onClose();
    };
    const pressed = (event: KeyboardEvent): void => {
      if (event.key === "Escape") onClose();
    };
    addEventListener("pointerdown", outside);
    addEventListener("keydown", pressed);
    return () => {
      removeEventListener("pointerdown", outside);
      removeEventListener("keydown", pressed);
    };
  }, []);
  const keep = async (): Promise<void> => {
    const answer = await keepView(name.value.trim());
    refusal.value = answer.ok ? undefined : answer;
  };
  const home = (): void => panel.current?.querySelector("button")?.focus();
  const forget = async (view: RunView): Promise<void> => {
    const answer = await forgetView(view);
    refusal.value = answer.ok ? undefined : answer;
    home();
  };
  const replaces = runViews.value?.some((view) => view.name === name.value.trim());
  return (
    <div ref={panel} class="views-menu" role="group" aria-label="Views of the list">
      <ul class="views-list" aria-label="Saved views, shared by all">
        <li>
          <button type="button" class="link" onClick={() => show(undefined)}>
            all runs
          </button>
        </li>
        {(runViews.value ?? []).map((view) => (
          <li key={view.name}>
            <button
              type="button"
              class="link ellipsis"
              aria-pressed={view === shownView.value}
              title={aboutOf(view)}
              onClick={() => {
                show(view);
                name.value = view.name;
              }}
            >
              {view.name}
            </button>
            <button
              type="button"
              class="quiet small"
              aria-label={`Forget the view ${view.name}`}
              onClick={() => void forget(view)}
            >
              <CrossIcon size={10} />
            </button>
          </li>
        ))}
      </ul>
      {runViews.value?.length === 0 && (
        <p class="muted">No view yet. Search, choose columns, and keep what you see under a name, for all.</p>
      )}
      {runViews.refusal && <p class="lost">Views cannot be read: {runViews.refusal.reason}</p>}
      <UndoView onDone={home} />
      <RefusalIn title="Not changed." of={refusal} />
      <form
        class="views-keep"
        onSubmit={(event) => {
          event.preventDefault();
          void keep();
        }}
      >
        <input
          aria-label="Name of the view"
          placeholder="Name this view"
          maxLength={60}
          value={name.value}
          onInput={(event) => {
            name.value = event.currentTarget.value;
          }}
        />
        <ActButton
          type="submit"
          class="action small"
          why={name.value.trim() ? "" : "Give the view a name first"}
        >
          {replaces ? "Replace" : "Save view"}
        </ActButton>
      </form>
      <fieldset class="views-columns">
        <legend class="muted">Columns</legend>
        {ALL.map((column) => (
          <label key={column} title={COLUMNS[column].about}>
            <input type="checkbox" checked={columns.value.includes(column)} onChange={() => toggle(column)} />{" "}
            {COLUMNS[column].name}
          </label>
        ))}
      </fieldset>
    </div>
  );
}

/** `onDone`: the button goes with what it took back, and must not take the focus along. */
function UndoView({ onDone }: { onDone: () => void }) {
  if (!undone.value) return null;
  return (
    <p class="take-back" role="status">
      <span class="ellipsis">{undone.value.text}</span>
      <button type="button" class="action small" onClick={() => void takeViewBack().then(onDone)}>
        <UndoIcon size={12} /> Undo
      </button>
    </p>
  );
}

function aboutOf(view: RunView): string {
  const what = [view.outcome.replace("_", " "), view.words].filter(Boolean).join(": ") || "all runs";
  return `${what}${view.author ? `; kept by ${view.author}` : ""}`;
}
