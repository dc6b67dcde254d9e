// As long as strangers may speak on the vehicle's bus the top line says so; nobody can wave it away.
import { live } from "../stream/store";
import { WarningIcon } from "../ui/icons";

export function OpenBus() {
  const notice = live.latest("server/status")?.busNotice;
  if (!notice) return null;
  return (
    <span class="chip" data-look="stale" role="status" title={notice}>
      <WarningIcon /> Bus without keys
    </span>
  );
}
