import { create, type MessageInitShape } from "@bufbuild/protobuf";
import { type Signal, signal } from "@preact/signals";
import { beforeEach, describe, expect, it } from "vitest";
import type { Answer } from "../api/http";
import type { CommandReply } from "../api/types";
import { type ParametersStatus, ParametersStatusSchema } from "../gen/bumpless_pb";
import { Draft } from "./draft";
import { flatOfJson, jsonOfFlat } from "./flat";

type Init = MessageInitShape<typeof ParametersStatusSchema>;
const Q = "hover.q_diagonal[2]";
const RAMP = "hover.ramp_cycles";

function status(q: number, ramp: number, revision: bigint): ParametersStatus {
  const hover = { qDiagonal: [1, 0, q], rampCycles: ramp };
  return create(ParametersStatusSchema, { active: { hover }, revision } satisfies Init);
}

const accepted = (revision: number): Answer<CommandReply> => ({
  ok: true,
  value: {
    ...{ accepted: true, reason: "", problems: [], run_id: "", revision },
    ...{ id: "", cause: "REFUSAL_CAUSE_UNSPECIFIED" },
  },
});

describe("the draft", () => {
  let said: Signal<ParametersStatus | undefined>;
  let sent: object[];
  let answer: Answer<CommandReply>;
  let draft: Draft;
  beforeEach(() => {
    said = signal<ParametersStatus | undefined>(status(4, 40, 1n));
    sent = [];
    answer = accepted(2);
    draft = new Draft(said, async (body) => {
      sent.push(body);
      return answer;
    });
  });

  it("shows what differs and forgets what equals the active value", () => {
    draft.set(Q, 6.5);
    draft.set(RAMP, 50);
    expect(draft.changedPaths.value).toEqual([Q, RAMP]);
    draft.set(Q, 4);
    expect(draft.changedPaths.value).toEqual([RAMP]);
    expect(draft.value(Q)).toBe(4);
  });

  it("takes edits of one field in a row as one step of undo", () => {
    for (const q of [6, 6.5, 7]) draft.set(Q, q);
    draft.endEdit();
    draft.set(Q, 8);
    draft.undo();
    expect(draft.value(Q)).toBe(7);
    draft.undo();
    expect([draft.value(Q), draft.canUndo.value]).toEqual([4, false]);
    draft.redo();
    draft.redo();
    expect([draft.value(Q), draft.canRedo.value]).toEqual([8, false]);
  });

  it("sends the whole set and is active only when the vehicle says so", async () => {
    draft.set(Q, 6.5);
    await draft.send();
    expect(sent).toEqual([jsonOfFlat({ ...draft.active.value, [Q]: 6.5 })]);
    expect([draft.apply.value.state, draft.changedPaths.value.length]).toEqual(["awaiting", 1]);
    said.value = status(6.5, 40, 2n);
    expect(draft.apply.value).toEqual({ state: "confirmed", revision: 2, count: 1 });
    expect([draft.changedPaths.value, draft.canUndo.value]).toEqual([[], false]);
  });

  it("calls out a vehicle that flies other values", async () => {
    draft.set(Q, 6.5);
    await draft.send();
    said.value = status(5, 40, 2n);
    expect(draft.apply.value).toEqual({ state: "differs", revision: 2, paths: [Q] });
    expect(draft.value(Q)).toBe(6.5);
  });

  it("ends the wait when another node counts from the beginning", async () => {
    said.value = status(4, 40, 7n);
    answer = accepted(8);
    draft.set(Q, 6.5);
    await draft.send();
    said.value = status(4, 40, 1n);
    expect(draft.apply.value.state).toBe("differs");
  });

  it("keeps the draft when the vehicle refuses", async () => {
    answer = { ok: false, status: 422, reason: "out of range", problems: [] };
    draft.set(Q, -1);
    await draft.send();
    expect([draft.apply.value.state, draft.value(Q)]).toEqual(["refused", -1]);
    draft.revertAll();
    expect(draft.apply.value.state).toBe("none");
  });

  it("lays a preset over what is active, known numbers alone", () => {
    draft.load({ [Q]: 9, [RAMP]: 40, "magic.x": 1 });
    expect(draft.changedPaths.value).toEqual([Q]);
  });
});

describe("flat parameters", () => {
  it("go to JSON and back", () => {
    const json = { forward: { lambda: 0.1, q_diagonal: [1, 0, 2] }, bumpless: { ramp: true } };
    expect(jsonOfFlat(flatOfJson(json))).toEqual(json);
  });
});
