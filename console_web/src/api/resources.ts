// What the page asks the server for, and the events after which it asks again.
import { Resource } from "../lib/resource";
import { live } from "../stream/store";
import type { MissionSummary, ParametersAnswer, RunSummary, VehicleInfo } from "./types";

export const missions = new Resource<MissionSummary[]>("api/missions");
export const runs = new Resource<RunSummary[]>("api/runs");
export const presets = new Resource<unknown[]>("api/presets");
export const vehicle = new Resource<VehicleInfo>("api/vehicle");
export const parameterRanges = new Resource<ParametersAnswer>("api/parameters");

/** Fetch anew what a change on the stream has made old. */
export function refreshOnNews(): void {
  let session = "";
  let recording = "";
  let connection = live.connection;
  live.onChange((changed) => {
    if (connection !== live.connection) {
      connection = live.connection;
      void missions.refresh();
      void runs.refresh();
      void presets.refresh();
    }
    const description = changed.has("tlm/description") && live.latest("tlm/description");
    if (description && description.sessionId + description.sha256 !== session) {
      session = description.sessionId + description.sha256;
      void vehicle.refresh();
      void parameterRanges.refresh();
    }
    const status = changed.has("server/status") && live.latest("server/status");
    if (status && `${status.recording}${status.recordingRunId}` !== recording) {
      recording = `${status.recording}${status.recordingRunId}`;
      void runs.refresh();
    }
  });
}
