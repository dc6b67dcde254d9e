// What a run is doing now: how long and how large.
import type { RunSummary } from "../api/types";
import { live } from "../stream/store";

/** A run being recorded grows on the stream, without asking the server again. */
export function useNow(run: RunSummary): { duration_s: number | null | undefined; bytes: number } {
  if (run.state !== "recording") return { duration_s: run.duration_s, bytes: run.bytes };
  const mission = live.latest("tlm/mission");
  const status = live.latest("server/status");
  return {
    duration_s: mission?.runId === run.id ? mission.elapsedS : run.duration_s,
    bytes: status?.recordingRunId === run.id ? Number(status.recordedBytes) : run.bytes,
  };
}
