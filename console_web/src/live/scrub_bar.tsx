// While the plots are held: how far they are behind, and a bar to look back along.
import { age } from "../lib/format";
import { heldAt, screen } from "../stream/screen";
import { follow, holdAt } from "./time_axis";

export function ScrubBar() {
  const held = heldAt.value;
  if (Number.isNaN(held)) return null;
  void screen.tick;
  const [first, last] = [screen.history.first(), screen.history.last()];
  const behind = Math.max(0, last - held);
  return (
    <div class="scrub" role="group" aria-label="Held plots">
      <span class="chip" data-look="paused" role="status">
        Held, <span class="num">{age(behind)}</span> behind
      </span>
      <input
        type="range"
        aria-label="Time that the plots end with"
        aria-valuetext={`${age(behind)} behind the present`}
        min={0}
        max={Math.max(1, last - first)}
        step={0.1}
        value={held - first}
        onInput={(event) => holdAt(first + Number(event.currentTarget.value))}
      />
      <button type="button" class="action small" onClick={follow}>
        To the present
      </button>
    </div>
  );
}
