import { describe, expect, it } from "vitest";
import type { AuditEntry } from "../api/types";
import { changesOf, found } from "./audited";

const entry = (details: AuditEntry["details"], more: Partial<AuditEntry> = {}): AuditEntry => ({
  time: "2026-01-01T00:00:00Z",
  id: "1",
  verb: "set_parameters",
  author: "ada",
  address: "10.0.0.1",
  details,
  answer: "accepted",
  said: "",
  took_s: 0.1,
  ...more,
});

describe("the audit in words", () => {
  it("tells what changed from what to what", () => {
    const changes = { "hover.lambda": [0.1, 0.2], "hover.q": [null, [1, 2]] };
    expect(changesOf(entry({ changes }))).toEqual(["hover.lambda 0.1 → 0.2", "hover.q null → [1,2]"]);
    expect(changesOf(entry({ name: "ben", role: ["observer", "operator"], password: false }))).toEqual([
      "name ben",
      "role observer → operator",
    ]);
  });

  it("finds lines by all the words that are typed", () => {
    const lines = [entry({}), entry({ mission: "docking.yaml" }, { verb: "start", author: "ben" })];
    expect(found(lines, "BEN docking")).toEqual([lines[1]]);
    expect(found(lines, "set parameters")).toEqual([lines[0]]);
    expect(found(lines, "")).toEqual(lines);
    expect(found(lines, "ben set")).toEqual([]);
  });
});
