import { describe, expect, it } from "vitest";
import { dateTime } from "./format";
import { zoneName } from "./zone";

describe("times of day", () => {
  it("say their zone", () => {
    expect(dateTime("2026-01-02T03:04:05Z", "UTC")).toBe("2026-01-02 03:04:05 UTC");
    const date = new Date("2026-07-01T00:00:00Z");
    date.getTimezoneOffset = () => -120;
    expect(zoneName(date, "local")).toBe("UTC+02:00");
    date.getTimezoneOffset = () => 210;
    expect(zoneName(date, "local")).toBe("UTC\u221203:30");
    expect(zoneName(date, "UTC")).toBe("UTC");
  });
});
