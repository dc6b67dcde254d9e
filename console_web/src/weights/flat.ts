// Parameters as a flat map "forward.q_diagonal[0]" -> value, and back to the contract's JSON.
import { type JsonValue, toJson } from "@bufbuild/protobuf";
import { type Parameters, ParametersSchema } from "../gen/bumpless_pb";

export type Value = number | boolean;
export type Flat = Readonly<Record<string, Value>>;

export function flatOfMessage(message: Parameters): Flat {
  return flatOfJson(toJson(ParametersSchema, message, { useProtoFieldName: true, alwaysEmitImplicit: true }));
}

/** Of the contract's JSON, and of the same as the server's interface has it. */
export function flatOfJson(json: JsonValue | object | undefined): Flat {
  const flat: Record<string, Value> = {};
  const walk = (value: unknown, path: string): void => {
    if (typeof value === "number" || typeof value === "boolean") flat[path] = value;
    else if (Array.isArray(value)) {
      for (const [index, item] of value.entries()) walk(item, `${path}[${index}]`);
    } else if (value && typeof value === "object") {
      for (const [key, item] of Object.entries(value)) walk(item, path ? `${path}.${key}` : key);
    }
  };
  walk(json, "");
  return flat;
}

export function jsonOfFlat(flat: Flat): Record<string, unknown> {
  const root: Record<string, unknown> = {};
  for (const [path, value] of Object.entries(flat)) {
    const match = /^(\w+)\.(\w+)(?:\[(\d+)\])?$/.exec(path);
    if (!match) continue;
    const [, section, key, index] = match as unknown as [string, string, string, string | undefined];
    root[section] ??= {};
    const group = root[section] as Record<string, unknown>;
    if (index === undefined) group[key] = value;
    else {
      group[key] ??= [];
      (group[key] as Value[])[Number(index)] = value;
    }
  }
  return root;
}
