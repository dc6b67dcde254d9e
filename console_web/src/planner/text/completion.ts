// Completion of keys and words from the fields that the server declares.
import type { Completion, CompletionContext, CompletionResult } from "@codemirror/autocomplete";
import type { FieldEntry } from "../forms/fields";
import { fields } from "../forms/fields";

/** The declared path that a line lies in, by its indentation: "target", "legs[]". */
export function pathAbove(lines: readonly string[], indent: number): string {
  const keys: string[] = [];
  let least = indent;
  for (const line of [...lines].reverse()) {
    const match = /^(\s*)(- )?([A-Za-z_]\w*):/.exec(line);
    const item = /^(\s*)- /.exec(line);
    if (item && (item[1]?.length ?? 0) < least && !match) continue;
    if (!match) continue;
    const depth = match[1]?.length ?? 0;
    if (match[2] && depth + 2 <= least && depth < least) {
      least = depth + 1;
      keys.unshift("[]");
      if (depth + 2 < indent) keys.splice(1, 0, match[3] ?? "");
      continue;
    }
    if (depth >= least) continue;
    keys.unshift(match[3] ?? "");
    least = depth;
    if (depth === 0) break;
  }
  return keys.join(".").replaceAll(".[]", "[]");
}

function optionOf(field: FieldEntry, key: string): Completion {
  const unit = field.unit ? `, ${field.unit}` : "";
  const opens = field.type === "part" || field.type === "list";
  return {
    label: key,
    apply: opens ? `${key}:` : `${key}: `,
    detail: `${field.label}${unit}`,
    info: field.help || undefined,
    type: "property",
  };
}

export function complete(context: CompletionContext): CompletionResult | null {
  const line = context.state.doc.lineAt(context.pos);
  const before = line.text.slice(0, context.pos - line.from);
  const lines = context.state.doc.sliceString(0, Math.max(0, line.from - 1)).split("\n");
  const value = /^\s*(?:- )?([A-Za-z_]\w*):\s+(\w*)$/.exec(before);
  const indent = /^\s*/.exec(before)?.[0].length ?? 0;
  const above = pathAbove(lines, indent);
  const prefix = above ? `${above}.` : "";
  if (value) {
    const field = fields.value?.find(({ path }) => path === prefix + value[1]);
    const words = field?.choices ?? (field?.type === "switch" ? ["true", "false"] : []);
    if (words.length === 0) return null;
    return {
      from: context.pos - (value[2]?.length ?? 0),
      options: words.map((label) => ({ label, type: "enum" })),
    };
  }
  const key = /^\s*(?:- )?([A-Za-z_]\w*)?$/.exec(before);
  const inFlow = /[{,]\s*([A-Za-z_]\w*)?$/.exec(before);
  const typed = key?.[1] ?? inFlow?.[1] ?? "";
  if (!key && !inFlow) return null;
  if (!typed && !context.explicit) return null;
  const options = keysOf(inFlow && !key ? flowPath(before, above) : above);
  return options.length ? { from: context.pos - typed.length, options, validFor: /^\w*$/ } : null;
}

function flowPath(before: string, above: string): string {
  const item = /^\s*- \{/.test(before);
  const key = /([A-Za-z_]\w*): \{[^}]*$/.exec(before)?.[1];
  if (item) return `${above}[]`;
  return key ? (above ? `${above}.${key}` : key) : above;
}

function keysOf(path: string): Completion[] {
  const prefix = path ? `${path}.` : "";
  return (fields.value ?? []).flatMap((field) => {
    if (!field.path.startsWith(prefix)) return [];
    const rest = field.path.slice(prefix.length);
    return /^[A-Za-z_]\w*$/.test(rest) ? [optionOf(field, rest)] : [];
  });
}
