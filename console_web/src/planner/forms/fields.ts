// What may stand in a mission, as the server declares it: one source for forms and completion.
import { ask } from "../../api/client";
import { Resource } from "../../api/resource";
import { endsIn, type Path } from "../model/paths";

export interface FieldEntry {
  path: string;
  type: "number" | "integer" | "text" | "choice" | "switch" | "row" | "part" | "list";
  label: string;
  help: string;
  unit: string;
  required: boolean;
  nullable: boolean;
  min?: number | number[] | null;
  max?: number | number[] | null;
  above?: number | null;
  names?: string[] | null;
  count?: number | null;
  choices?: string[];
  default?: unknown;
  fewest?: number;
  most?: number;
  form?: string;
}

export const fields = new Resource(async () => {
  const answer = await ask("get", "/api/fields/{kind}", { path: { kind: "mission" } });
  return answer.ok ? { ok: true as const, value: answer.value as unknown as FieldEntry[] } : answer;
});

/** "legs[0].to_ned_m" as it is declared: "legs[].to_ned_m". */
export function declared(path: Path): string {
  return path.reduce<string>(
    (made, key) => (typeof key === "number" ? `${made}[]` : made ? `${made}.${key}` : key),
    "",
  );
}

/** Entries right below a declared path, in the order of the declaration. */
export function below(all: readonly FieldEntry[], parent: string): FieldEntry[] {
  const prefix = parent ? `${parent}.` : "";
  return all.filter(({ path }) => path.startsWith(prefix) && endsIn(path.slice(prefix.length)));
}

function bound(limit: number | number[] | null | undefined, index: number): number | undefined {
  const value = Array.isArray(limit) ? limit[index] : limit;
  return typeof value === "number" ? value : undefined;
}

/** Why a number is refused; "" when it may stand. */
export function refusal(field: FieldEntry, value: number, index = 0): string {
  if (!Number.isFinite(value)) return "must be a number";
  if (field.type === "integer" && !Number.isInteger(value)) return "must be a whole number";
  const [low, high] = [bound(field.min, index), bound(field.max, index)];
  if (low !== undefined && value < low) return `must be at least ${low}`;
  if (high !== undefined && value > high) return `must be at most ${high}`;
  if (typeof field.above === "number" && value <= field.above) return `must be more than ${field.above}`;
  return "";
}

/** "0 to 360 deg", for the tooltip. */
export function rangeOf(field: FieldEntry, index = 0): string {
  const [low, high] = [bound(field.min, index), bound(field.max, index)];
  const unit = field.unit ? ` ${field.unit}` : "";
  if (low !== undefined && high !== undefined) return `${low} to ${high}${unit}`;
  if (low !== undefined) return `at least ${low}${unit}`;
  return high === undefined ? field.unit : `at most ${high}${unit}`;
}

/** A number as typed, with decimal comma, true minus sign or leading zeros; undefined when it is none. */
export function typed(text: string): number | undefined {
  const clean = text.trim().replace("\u2212", "-").replace(",", ".");
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(clean) ? Number(clean) : undefined;
}

/** What a new entry or part begins with: its required fields, at their least. */
export function beginning(all: readonly FieldEntry[], parent: string): Record<string, unknown> {
  const made: Record<string, unknown> = {};
  for (const field of below(all, parent)) {
    if (!field.required) continue;
    const key = field.path.split(".").at(-1) ?? "";
    const low = Array.isArray(field.min) ? field.min[0] : field.min;
    if (field.type === "row") made[key] = (field.names ?? []).map(() => 0);
    else if (field.type === "choice") made[key] = field.choices?.[0];
    else if (field.type === "text") made[key] = "";
    else if (field.type === "switch") made[key] = false;
    else if (field.type === "part") made[key] = beginning(all, field.path);
    else if (field.type !== "list") made[key] = field.default ?? Math.max(low ?? 0, 0);
  }
  return made;
}
