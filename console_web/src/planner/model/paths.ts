// Paths into a document, and as the server writes them.
export type Path = readonly (string | number)[];

/** "legs[0].to_ned_m" as keys and places. */
export function pathOf(field: string): Path {
  return [...field.matchAll(/([^.[\]]+)|\[(\d+)\]/g)].map((m) =>
    m[2] === undefined ? (m[1] ?? "") : Number(m[2]),
  );
}

export function fieldOf(path: Path): string {
  return path.reduce<string>(
    (made, key) => (typeof key === "number" ? `${made}[${key}]` : made ? `${made}.${key}` : key),
    "",
  );
}

/** Whether the rest of a declared path is one step: "wave", not "wave.height_m" nor "legs[].speed_mps". */
export function endsIn(rest: string): boolean {
  return /^[A-Za-z_]\w*$/.test(rest);
}
