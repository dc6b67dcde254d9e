import { describe, expect, it } from "vitest";
import { tileCorner, tilesOver } from "./tile_numbers";

describe("tiles of a web map", () => {
  it("hold the place that they are found for", () => {
    const [one] = tilesOver([[54.4, 10.2]], 0.01, 54.4);
    if (!one) throw new Error("no tile");
    const [[north, west], [south, east]] = [tileCorner(one, 0, 0), tileCorner(one, 1, 1)];
    expect(south < 54.4 && 54.4 < north && west < 10.2 && 10.2 < east).toBe(true);
  });
  it("are numbered as everybody numbers them", () => {
    // Null Island at zoom 1 begins the lower right tile; the upper left corner of the world is (0, 0).
    expect(tilesOver([[-1, 1]], 1e-5, 0)[0]).toEqual({ z: 1, x: 1, y: 1 });
    const [latitude, longitude] = tileCorner({ z: 0, x: 0, y: 0 }, 0, 0);
    expect(latitude).toBeCloseTo(85.0511, 3);
    expect(longitude).toBe(-180);
  });
  it("are never more than a handful, however far the view", () => {
    const far = tilesOver(
      [
        [54.5, 10],
        [54.5, 10.4],
        [54.3, 10.4],
        [54.3, 10],
      ],
      20,
      54.4,
    );
    expect(far.length).toBeGreaterThan(0);
    expect(far.length).toBeLessThanOrEqual(64);
  });
});
