// The allowed range of a field, as the server's table has it.
import { parameterRanges } from "../api/resources";
import type { Range } from "../api/types";
import { compact } from "../lib/format";

export function rangeOf(path: string): Range | undefined {
  const bare = path.replace(/\[\d+\]$/, "");
  return parameterRanges.value?.ranges.find((range) => range.path === path || range.path === bare);
}

export function rangeText(range: Range | undefined): string {
  if (!range) return "";
  const unit = range.unit && range.unit !== "1" ? ` ${range.unit}` : "";
  return `${compact(range.min)} to ${compact(range.max)}${unit}`;
}

export function isOutside(path: string, value: number): boolean {
  const range = rangeOf(path);
  return Boolean(range) && !(value >= (range as Range).min && value <= (range as Range).max);
}

/** Numbers of a section that may change in flight and that no list below names, so that none is out of reach. */
export function otherNumbers(section: string, named: readonly string[]): Range[] {
  const all = parameterRanges.value?.ranges ?? [];
  return all.filter(({ path, count }) => {
    const [where, key] = path.split(".") as [string, string];
    return where === section && count === 0 && !named.includes(key);
  });
}
