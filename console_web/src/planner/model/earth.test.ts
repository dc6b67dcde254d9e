import { describe, expect, it } from "vitest";
import { earthWords, originOf, toEarth, toLocal } from "./earth";

describe("a place on the earth", () => {
  it("leads there and back, turned and over the date line", () => {
    for (const longitude of [10.2, 179.9999])
      for (const heading of [0, 20, 215]) {
        const origin = { latitude: 54.4, longitude, heading };
        const there = toLocal(origin, ...toEarth(origin, 120, -45));
        expect(there[0]).toBeCloseTo(120, 5);
        expect(there[1]).toBeCloseTo(-45, 5);
      }
  });
  it("is told with its hemisphere, and only where there is an origin", () => {
    expect(earthWords([-54.4, 10.25])).toBe("54.400000° S 10.250000° E");
    expect(originOf({ origin: { latitude_deg: 54 } })).toBeUndefined();
    expect(originOf({ origin: { latitude_deg: 54, longitude_deg: 10 } })).toMatchObject({ heading: 0 });
  });
});
