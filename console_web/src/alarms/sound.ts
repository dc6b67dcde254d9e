// Two tones for an alarm that is new, three and higher for a critical one. Silent until the operator chooses.
import { effect, signal } from "@preact/signals";
import { unseen } from "./alarms";
import { priorityOf } from "./looks";

const KEY = "bumpless.sound";
const LOUD = 0.12;

function kept(): boolean {
  try {
    return localStorage.getItem(KEY) === "on";
  } catch {
    return false;
  }
}

export const heard = signal(kept());
let context: AudioContext | undefined;

export function setHeard(on: boolean): void {
  heard.value = on;
  try {
    localStorage.setItem(KEY, on ? "on" : "off");
  } catch {
    // Without storage the choice lasts as long as the page.
  }
  if (on) play(3); // browsers let a page sound after a press: this is it
}

function play(priority: number): void {
  context ??= new AudioContext();
  void context.resume();
  const tones = priority === 1 ? [880, 1175, 880] : [660, 660];
  tones.forEach((hertz, k) => {
    const [tone, gain] = [
      new OscillatorNode(context as AudioContext, { frequency: hertz }),
      context?.createGain(),
    ];
    if (!gain || !context) return;
    const from = context.currentTime + 0.25 * k;
    gain.gain.setValueAtTime(0, from);
    gain.gain.linearRampToValueAtTime(LOUD, from + 0.02);
    gain.gain.linearRampToValueAtTime(0, from + 0.2);
    tone.connect(gain).connect(context.destination);
    tone.start(from);
    tone.stop(from + 0.22);
  });
}

let known = new Set<string>();
let first = true;

effect(() => {
  const now = unseen.value;
  const key = ({ id, count }: { id: string; count: number }): string => `${id}/${count}`;
  const fresh = now.filter((alarm) => !known.has(key(alarm)));
  known = new Set(now.map(key));
  if (!first && fresh.length && heard.peek()) play(Math.min(...fresh.map(priorityOf)));
  first = false;
});
