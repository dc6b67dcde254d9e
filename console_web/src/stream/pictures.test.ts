import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { pictures } from "./pictures";

beforeEach(() => void vi.useFakeTimers({ toFake: ["performance", "setTimeout", "clearTimeout"] }));
afterEach(() => void vi.useRealTimers());

it("shows the first at once and what comes after it when the pause is over, the last never lost", () => {
  const shown: number[] = [];
  const soon = pictures(100, (run) => run());
  const show = (value: number): void => soon(() => shown.push(value));
  show(1);
  expect(shown).toEqual([1]);
  show(2);
  vi.advanceTimersByTime(90);
  expect(shown).toEqual([1]);
  vi.advanceTimersByTime(20);
  expect(shown).toEqual([1, 2]);
  vi.advanceTimersByTime(500);
  show(3);
  expect(shown).toEqual([1, 2, 3]);
});
