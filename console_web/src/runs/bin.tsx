// The flight that was thrown away last can be taken back at once, all its files.
import { signal } from "@preact/signals";
import { ask } from "../api/client";
import type { Answer } from "../api/http";
import { runs } from "../api/resources";
import { UndoIcon } from "../ui/icons";

/** Ids of the files that this page put into the bin last. */
export const thrown = signal<readonly string[]>([]);

/** Its last piece first: what stays when one is refused is a flight from its beginning. */
export async function throwAway(pieces: readonly string[]): Promise<Answer<unknown>> {
  let answer: Answer<unknown> = { ok: true, value: undefined };
  const gone: string[] = [];
  for (const run of [...pieces].reverse()) {
    answer = await ask("delete", "/api/runs/{run}", { path: { run } });
    if (!answer.ok) break;
    gone.unshift(run);
  }
  if (gone.length) thrown.value = gone;
  return answer;
}

export function TakeBack() {
  const [first, ...more] = thrown.value;
  if (!first) return null;
  const restore = async (): Promise<void> => {
    for (const run of thrown.value) {
      const answer = await ask("post", "/api/bin/{run}/restore", { path: { run } });
      if (answer.ok || answer.status === 404) thrown.value = thrown.value.filter((other) => other !== run);
    }
    await runs.refresh();
  };
  return (
    <p class="take-back" role="status">
      <span class="ellipsis">
        {first} {more.length ? `and ${more.length} more of its pieces are` : "is"} in the bin.
      </span>
      <button type="button" class="action small" onClick={() => void restore()}>
        <UndoIcon size={12} /> Undo
      </button>
    </p>
  );
}
