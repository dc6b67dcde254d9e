// Where a line is drawn without a gap.
/** Runs of rows that have a reference. */
export function stretches(
  length: number,
  value: (i: number) => number | null | undefined,
): [from: number, to: number][] {
  const found: [number, number][] = [];
  let from = -1;
  for (let i = 0; i <= length; i++) {
    const there = i < length && value(i) != null;
    if (there && from < 0) from = i;
    if (!there && from >= 0) {
      found.push([from, i - 1]);
      from = -1;
    }
  }
  return found;
}
