// Above a replayed run: that it is no live picture, the scrubber with modes and events, speed and steps.
import { useEffect } from "preact/hooks";
import { runs } from "../api/resources";
import { clock } from "../lib/format";
import { href } from "../shell/address";
import { flying } from "../stream/link";
import { Canvas } from "../ui/canvas";
import { PauseIcon, PlayIcon, UndoIcon } from "../ui/icons";
import { noteTime } from "./current";
import { paintLane } from "./lane";
import { type Replay, SPEEDS } from "./replay";
import "./replay_bar.css";

const PERIOD_S = 0.05;
const KEYS: Record<string, (replay: Replay, far: boolean) => void> = {
  " ": (replay) => (replay.playing.peek() ? halt(replay) : replay.play()),
  ArrowLeft: (replay, far) => step(replay, far ? -10 : -1),
  ArrowRight: (replay, far) => step(replay, far ? 10 : 1),
  ",": (replay) => step(replay, -PERIOD_S),
  ".": (replay) => step(replay, PERIOD_S),
  Home: (replay) => to(replay, replay.first),
  End: (replay) => to(replay, replay.last),
};

function to(replay: Replay, t: number): void {
  void replay.seek(t).then(() => noteTime(replay));
}

function step(replay: Replay, seconds: number): void {
  to(replay, replay.t.peek() + seconds);
}

function halt(replay: Replay): void {
  replay.pause();
  noteTime(replay);
}

function useKeys(replay: Replay): void {
  useEffect(() => {
    const press = (event: KeyboardEvent): void => {
      const own = event.target as HTMLElement;
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (own.matches("input:not([type=range]), textarea, select, [contenteditable]")) return;
      if (event.key === " " && own.matches("button, a, summary")) return;
      const act = KEYS[event.key];
      if (!act) return;
      event.preventDefault();
      act(replay, event.shiftKey);
    };
    addEventListener("keydown", press);
    return () => removeEventListener("keydown", press);
  }, [replay]);
}

export function ReplayBar({ replay }: { replay: Replay }) {
  useKeys(replay);
  const run = runs.value?.find(({ id }) => id === replay.run);
  const t = replay.t.value;
  const gap = replay.gap.value;
  return (
    <section class="replay-bar" aria-label="Replay">
      <p class="replay-what">
        <strong>Replay</strong>
        <span class="ellipsis" title={replay.run}>
          {run?.title || run?.mission || replay.run}
        </span>
        <span class="muted">recorded; nothing here is live</span>
        {gap && (
          <span class="replay-gap" role="status">
            Not recorded from T+{clock(gap[0])} to {clock(gap[1])}: what is shown was said last before{" "}
            <button type="button" class="action small" onClick={() => to(replay, gap[1])}>
              Skip
            </button>
          </span>
        )}
        <span class="grow" />
        {replay.trouble.value && <span class="lost">{replay.trouble.value}</span>}
        <a class="action small" href={href("runs", replay.run)}>
          Run
        </a>
        <a class="action small" href={href("live")}>
          <UndoIcon size={12} /> Back to live{flying.value ? ": the vehicle flies" : ""}
        </a>
      </p>
      <div class="replay-line">
        <button
          type="button"
          class="action"
          aria-label={replay.playing.value ? "Pause the replay" : "Play"}
          title="Space"
          onClick={() => (replay.playing.value ? halt(replay) : replay.play())}
        >
          {replay.playing.value ? <PauseIcon /> : <PlayIcon />}
        </button>
        <span class="num replay-time">
          T+{clock(t)}.{Math.floor((t * 10) % 10)} <span class="muted">/ {clock(replay.last)}</span>
        </span>
        <div class="scrubber">
          <Canvas
            name="Modes and events of the whole run"
            class="replay-lane"
            paint={(g, width, height) => paintLane(replay, g, width, height)}
          />
          <input
            type="range"
            hidden={!replay.about.value}
            aria-label="Mission time"
            aria-valuetext={`${t.toFixed(1)} seconds after the start`}
            min={replay.first}
            max={replay.last}
            step={PERIOD_S}
            value={t}
            onInput={(event) => void replay.seek(Number(event.currentTarget.value))}
            onChange={() => noteTime(replay)}
            title="Arrows: 1 s, with Shift 10 s; comma and full stop: one cycle"
          />
        </div>
        <select
          class="small"
          aria-label="Speed"
          value={replay.speed.value}
          onChange={(event) => {
            replay.speed.value = Number(event.currentTarget.value);
          }}
        >
          {SPEEDS.map((speed) => (
            <option key={speed} value={speed}>
              {speed}×
            </option>
          ))}
        </select>
      </div>
    </section>
  );
}
