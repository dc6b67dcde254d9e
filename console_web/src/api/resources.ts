// What the page asks the server for, and the news after which it asks again.
import { effect, untracked } from "@preact/signals";
import { live } from "../stream/store";
import { ask } from "./client";
import { Resource } from "./resource";

export const missions = new Resource(() => ask("get", "/api/missions"));
/** Who this browser is to the server. */
export const me = new Resource(() => ask("get", "/api/me"));
export const runs = new Resource(() => ask("get", "/api/runs"));
export const runsDisk = new Resource(() => ask("get", "/api/runs-disk"));
export const presets = new Resource(() => ask("get", "/api/presets"));
export const vehicle = new Resource(() => ask("get", "/api/vehicle"));
export const revisions = new Resource(() => ask("get", "/api/parameters/revisions"));
export const parameterRanges = new Resource(() => ask("get", "/api/parameters"));

/** Call `act` when `news` gives another value than before; not for the first. */
function on<T>(news: () => T, act: () => void): void {
  let before = untracked(news);
  effect(() => {
    const now = news();
    if (now === before) return;
    before = now;
    untracked(act);
  });
}

/** Fetch anew what a change on the stream has made old. */
export function refreshOnNews(): void {
  on(
    () => live.connection.value,
    () => {
      void me.refresh();
      void missions.refresh();
      void runs.refresh();
      void presets.refresh();
    },
  );
  on(
    () => {
      const description = live.latest("tlm/description");
      return description && description.sessionId + description.sha256;
    },
    () => {
      void vehicle.refresh();
      void parameterRanges.refresh();
    },
  );
  on(
    () => {
      const status = live.latest("server/status");
      return status && `${status.recording}${status.recordingRunId}`;
    },
    () => {
      void runs.refresh();
      if (runsDisk.peek()) void runsDisk.refresh();
    },
  );
  on(
    () => live.events.find(({ code }) => code === "run_found")?.stamp?.timeNs,
    () => void runs.refresh(),
  );
}
