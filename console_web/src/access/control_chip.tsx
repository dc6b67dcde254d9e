// Beside the commands: who holds control. It leads to where control is asked for, handed over and taken.
import { me } from "../api/resources";
import { href } from "../shell/address";
import { live } from "../stream/store";
import { WarningIcon } from "../ui/icons";
import { control, heldByOther, holds } from "./control";
import "./control_chip.css";

export function ControlChip() {
  const state = control.value;
  const asking = state?.requests.length ?? 0;
  // who is alone at its console has control and needs no word of it
  const alone = holds.value && !me.value?.accounts && asking === 0;
  if (!state || alone || live.connection.value !== "open") return null;
  const name = holds.value ? "yours" : state.holder ? state.holderName : "free";
  const about = holds.value
    ? "This browser starts, resumes and tunes. System shows who asks for control."
    : "Only who holds control starts, resumes and tunes. Hold and abort are open to every operator.";
  const urgent = heldByOther.value || asking > 0;
  return (
    <a
      class="chip control-chip"
      data-look={urgent ? "stale" : "off"}
      href={href("system", "people")}
      title={about}
      aria-label={`Control: ${name}${asking ? `, ${asking} asking` : ""}`}
    >
      {urgent && <WarningIcon />}
      <span class="ellipsis">
        <span class="control-word">Control: </span>
        {name}
        {asking > 0 && `, ${asking} asking`}
      </span>
    </a>
  );
}
