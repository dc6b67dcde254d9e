// The run that the address asks to see again: "#/runs/<id>?t=31.2".
import { computed, effect, signal, untracked } from "@preact/signals";
import { address, go } from "../shell/address";
import { showLive, showRun } from "../stream/screen";
import { Replay } from "./replay";

/** Its id; "" while the Live view shows the stream. */
export const replayed = computed(() => {
  const { view, id, query } = address.value;
  return view === "runs" && query.t !== undefined ? id : "";
});

export const replay = signal<Replay | undefined>(undefined);

const timeOf = (): number => Number(address.peek().query.t) || 0;

effect(() => {
  const run = replayed.value;
  untracked(() => {
    replay.value?.close();
    if (!run) {
      replay.value = undefined;
      showLive();
      return;
    }
    const opened = new Replay(run);
    replay.value = opened;
    showRun({ source: opened, history: opened.history, until: () => opened.until() });
    void opened.open(timeOf());
  });
});

/** The address follows the playhead, so that a link shows what is seen. */
export function noteTime(of: Replay): void {
  go("runs", of.run, { t: of.t.peek().toFixed(2) }, true);
}
