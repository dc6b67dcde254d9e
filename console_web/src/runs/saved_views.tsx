// Filters of the list by a name, kept in this browser.
import { signal } from "@preact/signals";
import { ActButton } from "../ui/act_button";
import type { Filter } from "./filter";

const KEY = "bumpless.run_views";
const MOST = 30;

export type Views = Readonly<Record<string, Filter>>;

/** What was kept, as far as it is a table of filters. */
export function viewsOf(text: string | null): Views {
  try {
    const told: unknown = JSON.parse(text ?? "{}");
    if (!told || typeof told !== "object" || Array.isArray(told)) return {};
    const entries = Object.entries(told as Record<string, Partial<Filter>>).filter(
      ([, view]) => typeof view?.words === "string" && typeof view.outcome === "string",
    );
    return Object.fromEntries(entries.slice(0, MOST)) as Views;
  } catch {
    return {};
  }
}

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

export const views = signal<Views>(viewsOf(stored()));

function keep(next: Views): void {
  views.value = next;
  try {
    localStorage.setItem(KEY, JSON.stringify(next));
  } catch {
    // Without storage they last as long as the page.
  }
}

interface Props {
  filter: Filter;
  onChoose: (filter: Filter) => void;
}

export function SavedViews({ filter, onChoose }: Props) {
  const same = (view: Filter): boolean => view.words === filter.words && view.outcome === filter.outcome;
  const named = Object.entries(views.value).find(([, view]) => same(view))?.[0];
  const empty = !filter.words.trim() && !filter.outcome;
  const nameOf = ({ words, outcome }: Filter): string =>
    [outcome.replace("_", " "), words.trim()].filter(Boolean).join(": ");
  return (
    <>
      <select
        class="small"
        aria-label="Saved view"
        value={named ?? ""}
        onChange={(event) => {
          const view = views.value[event.currentTarget.value];
          onChoose(view ?? { words: "", outcome: "" });
        }}
      >
        <option value="">{empty ? "all runs" : "not saved"}</option>
        {Object.keys(views.value).map((name) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
      {named === undefined ? (
        <ActButton
          class="action small"
          why={empty ? "Search for something or choose an outcome first" : ""}
          title="Keep this search and outcome as a view"
          onAct={() => keep({ ...views.value, [nameOf(filter)]: filter })}
        >
          Save view
        </ActButton>
      ) : (
        <button
          type="button"
          class="action small"
          onClick={() =>
            keep(Object.fromEntries(Object.entries(views.value).filter(([name]) => name !== named)))
          }
        >
          Forget view
        </button>
      )}
    </>
  );
}
