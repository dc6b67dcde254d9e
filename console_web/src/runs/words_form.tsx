// A run's title, tags and note, written beside its log.
import { useSignal } from "@preact/signals";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { runs } from "../api/resources";
import type { RunSummary } from "../api/types";
import { ActButton } from "../ui/act_button";
import { RefusalIn } from "../ui/refusal";

export function WordsForm({ run }: { run: RunSummary }) {
  const title = useSignal(run.title);
  const tags = useSignal(run.tags.join(", "));
  const note = useSignal(run.note);
  const refusal = useSignal<Refusal | undefined>(undefined);
  const changed = title.value !== run.title || tags.value !== run.tags.join(", ") || note.value !== run.note;
  const save = async (): Promise<void> => {
    const body = {
      title: title.value,
      tags: tags.value
        .split(",")
        .map((tag) => tag.trim())
        .filter(Boolean),
      note: note.value,
    };
    const answer = await ask("put", "/api/runs/{run}/words", { path: { run: run.id }, body });
    refusal.value = answer.ok ? undefined : answer;
    if (answer.ok) await runs.refresh();
  };
  return (
    <form
      class="words"
      aria-label="Title, tags and note"
      onSubmit={(event) => {
        event.preventDefault();
        void save();
      }}
    >
      <label>
        <span class="muted">Title</span>
        <input
          value={title.value}
          maxLength={120}
          placeholder={run.mission}
          onInput={(event) => {
            title.value = event.currentTarget.value;
          }}
        />
      </label>
      <label>
        <span class="muted">Tags</span>
        <input
          value={tags.value}
          placeholder="calm, trial 3"
          title="Separated by commas"
          onInput={(event) => {
            tags.value = event.currentTarget.value;
          }}
        />
      </label>
      <label class="words-note">
        <span class="muted">Note</span>
        <input
          value={note.value}
          maxLength={4000}
          onInput={(event) => {
            note.value = event.currentTarget.value;
          }}
        />
      </label>
      <ActButton
        type="submit"
        class="action small"
        why={changed ? "" : "Title, tags and note are as they are kept"}
      >
        Save
      </ActButton>
      <RefusalIn title="Not saved." of={refusal} />
    </form>
  );
}
