// The run that was thrown away last can be taken back at once.
import { signal } from "@preact/signals";
import { ask } from "../api/client";
import { runs } from "../api/resources";
import { UndoIcon } from "../ui/icons";

/** Id of the run that this page put into the bin last. */
export const thrown = signal("");

export async function throwAway(run: string) {
  const answer = await ask("delete", "/api/runs/{run}", { path: { run } });
  if (answer.ok) thrown.value = run;
  return answer;
}

export function TakeBack() {
  const run = thrown.value;
  if (!run) return null;
  const restore = async (): Promise<void> => {
    const answer = await ask("post", "/api/bin/{run}/restore", { path: { run } });
    if (answer.ok || answer.status === 404) thrown.value = "";
    await runs.refresh();
  };
  return (
    <p class="take-back" role="status">
      <span class="ellipsis">{run} is in the bin.</span>
      <button type="button" class="action small" onClick={() => void restore()}>
        <UndoIcon size={12} /> Undo
      </button>
    </p>
  );
}
