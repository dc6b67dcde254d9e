// How a run in the list ended.
import type { RunSummary } from "../api/types";
import { ENDINGS, type Look } from "../ui/endings";
import { InfoIcon, RecordIcon } from "../ui/icons";

/** Of a run that is recorded, that it is; of one without a judgement, how its recording ended. */
function lookOf(run: RunSummary): Look {
  if (run.state === "recording") {
    return { word: "recording", look: "recording", Icon: RecordIcon, about: "Still flying" };
  }
  if (run.outcome) return ENDINGS[run.outcome];
  return run.state === "interrupted"
    ? ENDINGS.interrupted
    : {
        word: "not judged",
        look: "unknown",
        Icon: InfoIcon,
        about: "The log tells too little to judge it",
      };
}

export function OutcomeChip({ run }: { run: RunSummary }) {
  const { word, look, Icon, about } = lookOf(run);
  return (
    <span class="chip" data-look={look} title={run.outcome_reason || about}>
      <Icon size={11} /> {word}
    </span>
  );
}
