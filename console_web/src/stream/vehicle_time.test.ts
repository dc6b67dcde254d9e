// Protects: what a vehicle with a clock that is hours off says of when is shown by the server's clock.
import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { EventSchema, StampSchema } from "../gen/bumpless_pb";
import { whenMs } from "./vehicle_time";

const at = (timeMs: number, details: Record<string, string> = {}) =>
  create(EventSchema, { stamp: create(StampSchema, { timeNs: BigInt(timeMs) * 1_000_000n }), details });

test("a vehicle's time is told by the server's clock", () => {
  expect(whenMs(at(10_000_000), 3600)).toBe(6_400_000);
  expect(whenMs(at(10_000_000), -3600)).toBe(13_600_000);
});

test("clocks that agree, and the server's own events, are left alone", () => {
  expect(whenMs(at(10_000_000), 0.02)).toBe(10_000_000);
  expect(whenMs(at(10_000_000, { source: "server" }), 3600)).toBe(10_000_000);
  expect(whenMs(create(EventSchema, {}), 3600)).toBeUndefined();
});
