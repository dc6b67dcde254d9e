// What stands against the plan, each with its place and the change that mends it.
import { ActButton } from "../../ui/act_button";
import { AlarmIcon, WarningIcon } from "../../ui/icons";
import { broken, selected } from "../model/plan";
import { jump } from "../text/jump";
import { plan } from "./forecast";
import type { Finding, TextProblem } from "./foresight";
import { mend, thingOf } from "./mend";
import "./findings.css";

export function Findings({ onPlace }: { onPlace: () => void }) {
  const forecast = plan.forecast.value;
  const wrong = broken.value;
  const findings = forecast?.findings ?? [];
  const problems = forecast?.problems ?? [];
  if (wrong) {
    return (
      <ul class="findings" aria-label="Findings">
        <li class="finding" data-severity="hard">
          <AlarmIcon size={16} />
          <p>The text can't be read: {wrong.reason}. The drawing shows it as it was before.</p>
        </li>
      </ul>
    );
  }
  if (findings.length + problems.length === 0) return null;
  return (
    <ul class="findings" aria-label="Findings" data-state={plan.current.value ? "fresh" : "older"}>
      {problems.map((problem) => (
        <Problem key={`${problem.field}:${problem.rule}`} problem={problem} onPlace={onPlace} />
      ))}
      {findings.map((finding) => (
        <One key={`${finding.code}:${finding.path}`} finding={finding} onPlace={onPlace} />
      ))}
    </ul>
  );
}

function Place({ path, line, onPlace }: { path: string; line: number; onPlace: () => void }) {
  return (
    <button
      type="button"
      class="link place code"
      title={line > 0 ? `Line ${line} of the text` : undefined}
      onClick={() => {
        const thing = thingOf(path);
        selected.value = thing ? [thing] : [];
        jump.value = line || undefined;
        onPlace();
      }}
    >
      {path || "mission"}
      {line > 0 && <span class="muted">:{line}</span>}
    </button>
  );
}

function Problem({ problem, onPlace }: { problem: TextProblem; onPlace: () => void }) {
  return (
    <li class="finding" data-severity="hard">
      <AlarmIcon size={16} />
      <div>
        <p>
          {problem.rule}
          {problem.value && <span class="muted"> (is {problem.value})</span>}
        </p>
        <Place path={problem.field} line={problem.line} onPlace={onPlace} />
      </div>
    </li>
  );
}

function One({ finding, onPlace }: { finding: Finding; onPlace: () => void }) {
  const hard = finding.severity === "hard";
  return (
    <li class="finding" data-severity={finding.severity}>
      {hard ? <AlarmIcon size={16} /> : <WarningIcon size={16} />}
      <div>
        <p>
          <span class="sr">{hard ? "Can't work: " : "Unlikely: "}</span>
          {finding.reason}
          {finding.change && <span class="muted"> {finding.change}</span>}
        </p>
        <p class="finding-foot">
          {finding.mends.map((one, i) => (
            <ActButton
              key={one.label}
              class={`action small ${i === 0 ? "primary" : ""}`}
              why={plan.current.value ? "" : "The text is no plan that could be mended"}
              onAct={() => mend(one)}
            >
              {one.label}
            </ActButton>
          ))}
          <Place path={finding.path} line={finding.line} onPlace={onPlace} />
        </p>
      </div>
    </li>
  );
}
