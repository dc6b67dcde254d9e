// What a flight is doing now: how long and how large.
import { live } from "../stream/store";
import { asOne, type Flight } from "./flights";

/** A run being recorded grows on the stream, without asking the server again. */
export function useNow(flight: Flight): { duration_s: number | null | undefined; bytes: number } {
  const one = asOne(flight);
  const { growing, holds } = flight;
  if (!growing) return { duration_s: one.duration_s, bytes: one.bytes };
  const mission = live.latest("tlm/mission");
  const status = live.latest("server/status");
  const grown = status?.recordingRunId === growing.id ? Number(status.recordedBytes) : growing.bytes;
  return {
    duration_s: !holds && mission?.runId === growing.run_id ? mission.elapsedS : one.duration_s,
    bytes: one.bytes - growing.bytes + grown,
  };
}
