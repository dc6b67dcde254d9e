import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { paced } from "./pace";

describe("a paced drawing", () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ["performance", "setTimeout", "clearTimeout"] }));
  afterEach(() => void vi.useRealTimers());

  it("shows the first at once and never loses the last", () => {
    let [value, drawn] = [0, -1];
    let count = 0;
    const draw = paced(() => {
      drawn = value;
      count += 1;
    }, 100);
    draw();
    expect(drawn).toBe(0);
    for (value = 1; value <= 3; value++) draw();
    value = 3;
    expect(drawn).toBe(0);
    vi.advanceTimersByTime(100);
    expect([drawn, count]).toEqual([3, 2]);
  });

  it("draws nothing once it was stopped", () => {
    let count = 0;
    const draw = paced(() => {
      count += 1;
    }, 100);
    draw();
    draw();
    draw.stop();
    vi.advanceTimersByTime(1000);
    expect(count).toBe(1);
  });
});
