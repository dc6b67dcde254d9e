// What was found against a start, to be read and ticked off by hand.
import type { Signal } from "@preact/signals";
import type { Finding } from "./fly/foresight";

interface AskProps {
  look: "warning" | "alarm";
  words: string;
  findings: readonly Finding[];
  ticked: Signal<boolean>;
}

export function Ask({ look, words, findings, ticked }: AskProps) {
  if (findings.length === 0) return null;
  return (
    <label class="preflight-ask" data-look={look}>
      <input
        type="checkbox"
        checked={ticked.value}
        onChange={(event) => {
          ticked.value = event.currentTarget.checked;
        }}
      />
      <span>
        {words}:
        {findings.map((finding) => (
          <span key={finding.code + finding.path} class="preflight-reason">
            {finding.reason}
          </span>
        ))}
      </span>
    </label>
  );
}
