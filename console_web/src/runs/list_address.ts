// What the list of runs shows, as the address says it: only what is not as usual.
import type { components } from "../gen/api";
import { ENDINGS } from "../ui/endings";
import { ALL, type Column, USUAL } from "./columns";

type Outcome = components["schemas"]["RunViewAnswer"]["outcome"];
type Query = Readonly<Record<string, string>>;

export interface Shown {
  words: string;
  outcome: Outcome;
  columns: readonly Column[];
}

export function tell({ words, outcome, columns }: Shown): Record<string, string> {
  const told: Record<string, string> = {};
  if (words.trim()) told.find = words;
  if (outcome) told.outcome = outcome;
  if (columns.join() !== USUAL.join()) told.columns = columns.join();
  return told;
}

/** Undefined where the address says nothing of it. What it can't mean is left out. */
export function asked({ find, outcome, columns }: Query): Shown | undefined {
  if (find === undefined && outcome === undefined && columns === undefined) return undefined;
  const known = outcome === "recording" || (outcome !== undefined && Object.hasOwn(ENDINGS, outcome));
  const wanted = columns?.split(",");
  return {
    words: find ?? "",
    outcome: known ? (outcome as Outcome) : "",
    columns: wanted ? ALL.filter((column) => wanted.includes(column)) : USUAL,
  };
}
