// How much time the mode strip and all plots show.
import { useFrame } from "../stream/frame";
import { setWindow, window_s, WINDOWS_S } from "./time_axis";

export function WindowChoice() {
  useFrame();
  return (
    <select
      class="small"
      aria-label="Time window of plots and mode strip"
      value={window_s()}
      onChange={(event) => setWindow(Number(event.currentTarget.value))}
    >
      {WINDOWS_S.map((seconds) => (
        <option key={seconds} value={seconds}>{seconds < 120 ? `${seconds} s` : `${seconds / 60} min`}</option>
      ))}
    </select>
  );
}
