// Under the mode lane: the ways out of the present mode, each a checklist by the vehicle's own evaluation.
import type { Guard, ModeExit } from "../gen/bumpless_pb";
import { modeLook } from "../lib/modes";
import { inForce, screen } from "../stream/screen";
import { CheckIcon, HollowIcon } from "../ui/icons";
import { ModeLetter } from "../ui/mode_mark";
import "./exits.css";
import { shareOf, whenWords, wordsOf } from "./guards";

export function Exits() {
  const told = screen.latest("tlm/exits");
  if (!told?.exits.length || !inForce.value) return null;
  return (
    <ul
      class="exits"
      aria-label="Ways out of this mode"
      data-state={screen.isFresh("tlm/exits") ? "fresh" : "stale"}
    >
      {told.exits.map((exit) => (
        <Row key={`${exit.to}${exit.name}`} exit={exit} />
      ))}
    </ul>
  );
}

function Row({ exit }: { exit: ModeExit }) {
  const mode = modeLook(exit.to);
  return (
    <li class="exit">
      <span class="exit-to">
        <span aria-hidden="true">→</span> <ModeLetter mode={mode} /> <span class="sr">{mode.name}: </span>
        {exit.name}
      </span>
      {exit.guards.map((guard) => (
        <Check key={guard.name} guard={guard} />
      ))}
      <span class="exit-when num">{whenWords(exit.expectedS)}</span>
    </li>
  );
}

function Check({ guard }: { guard: Guard }) {
  return (
    <span class="guard num" data-met={guard.met ? "yes" : "no"}>
      {guard.met ? <CheckIcon size={10} /> : <HollowIcon size={10} />} {wordsOf(guard)}
      <span class="sr">{guard.met ? ", met" : ", not met"}</span>
      <i style={{ width: `${(100 * shareOf(guard)).toFixed(0)}%` }} />
    </span>
  );
}
