// A refusal as it came: the reason in one sentence, then each problem with its place and rule.
import type { Signal } from "@preact/signals";
import type { Refusal } from "../api/http";
import type { Problem } from "../api/types";
import { AlarmIcon, CrossIcon } from "./icons";
import "./refusal.css";

export function RefusalNotice({
  title,
  refusal,
  onClose,
}: {
  title: string;
  refusal: Refusal;
  onClose?: () => void;
}) {
  return (
    <div class="refusal" role="alert">
      <AlarmIcon size={16} />
      <p>
        <strong>{title}</strong> <span>{refusal.reason}</span>
      </p>
      {onClose && (
        <button type="button" class="quiet" aria-label="Dismiss" onClick={onClose}>
          <CrossIcon />
        </button>
      )}
    </div>
  );
}

/** The refusal that a signal holds, until it is dismissed. */
export function RefusalIn({ title, of }: { title: string; of: Signal<Refusal | undefined> }) {
  if (!of.value) return null;
  const dismiss = (): void => {
    of.value = undefined;
  };
  return <RefusalNotice title={title} refusal={of.value} onClose={dismiss} />;
}

export function ProblemTable({ problems }: { problems: Problem[] }) {
  const inFile = problems.some((p) => p.file || p.line);
  return (
    <table class="problems" aria-label="Problems">
      <thead>
        <tr>
          {inFile && <th scope="col">File</th>}
          {inFile && (
            <th scope="col" class="num">
              Line
            </th>
          )}
          <th scope="col">Field</th>
          <th scope="col">Value</th>
          <th scope="col">Rule</th>
        </tr>
      </thead>
      <tbody>
        {problems.map((p) => (
          <tr key={`${p.line}:${p.column}:${p.field}:${p.rule}`}>
            {inFile && <td>{p.file || "–"}</td>}
            {inFile && <td class="num">{place(p)}</td>}
            <td class="code">{p.field || "–"}</td>
            <td class="code">{p.value || "–"}</td>
            <td>{p.rule}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function place(problem: Problem): string {
  if (!problem.line) return "–";
  return problem.column ? `${problem.line}:${problem.column}` : String(problem.line);
}
