// What must not be overlooked: the server or the vehicle is out of reach, so nothing is present.
import { age } from "../lib/format";
import { useFrame } from "../stream/frame";
import { live } from "../stream/store";
import { AlarmIcon, WarningIcon } from "../ui/icons";
import { isFlying, linkNow } from "./link_state";

export function Banner() {
  useFrame();
  const link = linkNow();
  if (link.look === "offline") {
    const since = (performance.now() - (live.lastFrame || live.lostAt)) / 1000;
    const retry = Math.max(0, (live.retryAt - performance.now()) / 1000);
    return (
      <div class="banner alarm" role="alert">
        <AlarmIcon size={20} />
        <strong>Connection to the server lost</strong>
        <span>
          Values are from {age(since)} ago. The vehicle flies on by itself.{" "}
          {live.connection === "lost" && (retry > 0 ? `Trying again in ${retry.toFixed(0)} s.` : "Trying again.")}
        </span>
      </div>
    );
  }
  const status = live.latest("server/status");
  if (link.look === "lost") {
    return (
      <div class="banner alarm" role="alert">
        <AlarmIcon size={20} />
        <strong>Link to the vehicle lost</strong>
        <span>
          Last telemetry {age(live.age("tlm/navigation"))} ago; values below are not present.{" "}
          {status?.nodeManaged ? "The server is starting the vehicle's node anew." : "Waiting for it to come back."}
        </span>
      </div>
    );
  }
  if (link.look === "stale") {
    return (
      <div class="banner warning" role="status">
        <WarningIcon size={20} />
        <strong>Telemetry is late</strong>
        <span>Last value {age(live.age("tlm/navigation"))} ago.</span>
      </div>
    );
  }
  const mission = live.latest("tlm/mission");
  if (status?.recorderTrouble && !status.recording && mission && isFlying(mission.phase)) {
    return (
      <div class="banner warning" role="alert">
        <WarningIcon size={20} />
        <strong>This run is not being recorded</strong>
        <span>Reason: {status.recorderTrouble}. The vehicle flies on.</span>
      </div>
    );
  }
  return null;
}
