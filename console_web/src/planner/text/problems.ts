// Problems and findings at their places in the text.
import type { Diagnostic } from "@codemirror/lint";
import type { Text } from "@codemirror/state";
import type { Forecast } from "../fly/foresight";

export function problemsIn(
  doc: Text,
  broken: { reason: string; at: number } | undefined,
  forecast: Forecast | undefined,
): Diagnostic[] {
  const found: Diagnostic[] = [];
  if (broken) {
    const at = Math.min(broken.at, doc.length);
    found.push({ from: at, to: doc.lineAt(at).to, severity: "error", message: broken.reason });
  }
  for (const problem of forecast?.problems ?? []) {
    const message = `${problem.field}: ${problem.rule}`;
    found.push({ ...range(doc, problem.line, problem.column), severity: "error", message });
  }
  for (const finding of forecast?.findings ?? []) {
    const severity = finding.severity === "hard" ? "error" : "warning";
    const message = [finding.reason, finding.change].filter(Boolean).join(" ");
    found.push({ ...range(doc, finding.line, finding.column), severity, message });
  }
  return found.sort((a, b) => a.from - b.from);
}

function range(doc: Text, line: number, column: number): { from: number; to: number } {
  const at = doc.line(Math.min(Math.max(1, line), doc.lines));
  return { from: Math.min(at.to, at.from + Math.max(0, column - 1)), to: at.to };
}
