// In the top line: who holds control. It leads to where control is asked for, handed over and taken.
import { href } from "../shell/address";
import { live } from "../stream/store";
import { WarningIcon } from "../ui/icons";
import { control, heldByOther, holds } from "./control";

export function ControlChip() {
  const state = control.value;
  if (!state || live.connection.value !== "open") return null;
  const asking = state.requests.length > 0;
  const name = holds.value ? "yours" : state.holder ? state.holderName : "free";
  const about = holds.value
    ? "This browser starts, resumes and tunes. Others ask for control in System."
    : "Only who holds control starts, resumes and tunes. Pause and abort are open to every operator.";
  return (
    <a
      class="chip control-chip"
      data-look={heldByOther.value || asking ? "stale" : "off"}
      href={href("system", "people")}
      title={about}
      aria-label={`Control: ${name}${asking ? ", asked for" : ""}`}
    >
      {(heldByOther.value || asking) && <WarningIcon />} Control {name}
      {asking && `, ${state.requests.length} asking`}
    </a>
  );
}
