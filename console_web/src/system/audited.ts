// What an audit's line says, in words.
import type { AuditEntry } from "../api/types";

function told(value: unknown): string {
  return typeof value === "string" ? value : (JSON.stringify(value) ?? "–");
}

/** "hover.lambda 0.1 → 0.2", "mission docking.yaml": what stands in the details, one each. */
export function changesOf(entry: AuditEntry): string[] {
  return Object.entries(entry.details).flatMap(([name, value]) => {
    if (value === null || value === false || value === "") return [];
    if (name === "changes" && typeof value === "object") return pairs(value as Record<string, unknown>);
    return Array.isArray(value) && value.length === 2 ? pairs({ [name]: value }) : [`${name} ${told(value)}`];
  });
}

function pairs(changes: Record<string, unknown>): string[] {
  return Object.entries(changes).map(([path, pair]) => {
    const [from, to] = Array.isArray(pair) ? pair : [undefined, pair];
    return `${path} ${told(from)} → ${told(to)}`;
  });
}

/** Those that hold all the words, anywhere. */
export function found(entries: readonly AuditEntry[], words: string): AuditEntry[] {
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
  return entries.filter((entry) => {
    const text = [entry.verb.replaceAll("_", " "), entry.author, entry.address, entry.answer, entry.said]
      .concat(changesOf(entry), entry.time)
      .join(" ")
      .toLowerCase();
    return wanted.every((word) => text.includes(word));
  });
}
