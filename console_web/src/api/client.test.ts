import { afterEach, describe, expect, it, vi } from "vitest";
import { address, ask } from "./client";

afterEach(() => vi.unstubAllGlobals());

function answering(status: number, body: unknown): void {
  vi.stubGlobal("fetch", async () => new Response(JSON.stringify(body), { status }));
}

describe("requests", () => {
  it("fill in the path, and keep what a name may hold out of it", () => {
    expect(address("/api/runs/{run}/metrics", { run: "a/b ?" })).toBe("api/runs/a%2Fb%20%3F/metrics");
    expect(address("/api/missions", {}, { name: "a&b", replace: true })).toBe(
      "api/missions?name=a%26b&replace=true",
    );
  });

  it("tell a refusal as it came", async () => {
    const problem = { file: "a.yaml", line: 3, column: 1, field: "x", value: "1", rule: "must be > 2" };
    answering(422, { detail: "one problem", problems: [problem] });
    const answer = await ask("get", "/api/runs");
    expect(answer).toEqual({ ok: false, status: 422, reason: "one problem", problems: [problem] });
  });

  it("prefer the vehicle's own words", async () => {
    answering(409, { detail: "the vehicle refuses 'start'", reason: "Battery at 12 %", problems: [] });
    expect(await ask("post", "/api/mission/start", { body: { name: "x" } })).toMatchObject({
      reason: "Battery at 12 %",
    });
  });

  it("say so when there is no server", async () => {
    vi.stubGlobal("fetch", async () => Promise.reject(new TypeError("down")));
    expect(await ask("get", "/api/runs")).toMatchObject({ ok: false, status: 0 });
  });
});
