import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { AlarmSchema } from "../gen/bumpless_pb";
import { stateOf } from "./alarms";

describe("an alarm", () => {
  it("stays until it was seen, whatever its cause does", () => {
    expect(stateOf(create(AlarmSchema, { raisedNs: 1n }), 0)).toBe("unacknowledged");
    expect(stateOf(create(AlarmSchema, { raisedNs: 1n, returnedNs: 2n }), 0)).toBe("returned");
    expect(stateOf(create(AlarmSchema, { raisedNs: 1n, acknowledgedNs: 2n }), 0)).toBe("acknowledged");
  });

  it("comes back by itself from the shelf", () => {
    const alarm = create(AlarmSchema, { raisedNs: 1n, shelvedUntilNs: 5_000_000n });
    expect([stateOf(alarm, 4), stateOf(alarm, 6)]).toEqual(["shelved", "unacknowledged"]);
  });
});
