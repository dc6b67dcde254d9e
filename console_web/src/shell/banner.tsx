// What must not be overlooked: the server or the vehicle is out of reach, so nothing is present.
import { age } from "../lib/format";
import { link, moving } from "../stream/link";
import { live } from "../stream/store";
import { AlarmIcon, WarningIcon } from "../ui/icons";
import "./banner.css";

export function Banner() {
  if (link.value.look === "offline") {
    const since = (live.now.value - (live.lastFrame || live.lostAt)) / 1000;
    const retry = Math.max(0, (live.retryAt - live.now.value) / 1000);
    return (
      <div class="banner alarm" role="alert">
        <AlarmIcon size={20} />
        <strong>Connection to the server lost</strong>
        <span>
          Values are from {age(since)} ago. {moving.value && "The vehicle flies on by itself. "}
          {live.connection.value === "lost" &&
            (retry > 0 ? `Trying again in ${retry.toFixed(0)} s.` : "Trying again.")}
        </span>
      </div>
    );
  }
  const status = live.latest("server/status");
  if (link.value.look === "lost") {
    return (
      <div class="banner alarm" role="alert">
        <AlarmIcon size={20} />
        <strong>Link to the vehicle lost</strong>
        <span>
          Last telemetry {age(live.age("tlm/navigation"))} ago; values below are not present.{" "}
          {status?.nodeManaged
            ? "The server is starting the vehicle's node anew."
            : "Waiting for it to come back."}
        </span>
      </div>
    );
  }
  if (link.value.look === "stale") {
    return (
      <div class="banner warning" role="status">
        <WarningIcon size={20} />
        <strong>Telemetry is late</strong>
        <span>Last value {age(live.age("tlm/navigation"))} ago.</span>
      </div>
    );
  }
  if (status?.recorderTrouble && !status.recording && moving.value) {
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
