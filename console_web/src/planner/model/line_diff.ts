// Two texts line by line: what stayed, went and came.

export interface DiffLine {
  kind: "same" | "gone" | "new";
  text: string;
}

/** By the longest common subsequence of the lines between the common beginning and end. */
export function lineDiff(from: string, to: string): DiffLine[] {
  const [a, b] = [from.split(/\r?\n/), to.split(/\r?\n/)];
  let start = 0;
  while (start < a.length && start < b.length && a[start] === b[start]) start++;
  let [ea, eb] = [a.length, b.length];
  while (ea > start && eb > start && a[ea - 1] === b[eb - 1]) [ea, eb] = [ea - 1, eb - 1];
  const same = (text: string): DiffLine => ({ kind: "same", text });
  return [
    ...a.slice(0, start).map(same),
    ...middle(a.slice(start, ea), b.slice(start, eb)),
    ...a.slice(ea).map(same),
  ];
}

function middle(a: readonly string[], b: readonly string[]): DiffLine[] {
  const width = b.length + 1;
  const long = new Uint32Array((a.length + 1) * width);
  const at = (i: number, j: number): number => long[i * width + j] ?? 0;
  for (let i = a.length - 1; i >= 0; i--)
    for (let j = b.length - 1; j >= 0; j--)
      long[i * width + j] = a[i] === b[j] ? at(i + 1, j + 1) + 1 : Math.max(at(i + 1, j), at(i, j + 1));
  const made: DiffLine[] = [];
  let [i, j] = [0, 0];
  while (i < a.length || j < b.length) {
    if (i < a.length && j < b.length && a[i] === b[j]) {
      made.push({ kind: "same", text: a[i] ?? "" });
      [i, j] = [i + 1, j + 1];
    } else if (i < a.length && (j >= b.length || at(i + 1, j) >= at(i, j + 1))) {
      made.push({ kind: "gone", text: a[i] ?? "" });
      i++;
    } else {
      made.push({ kind: "new", text: b[j] ?? "" });
      j++;
    }
  }
  return made;
}

/** Only what changed, with some lines around it; a gap is an entry without a kind. */
export function around(lines: readonly DiffLine[], context: number): (DiffLine | undefined)[] {
  const near = lines.map((_, i) =>
    lines.slice(Math.max(0, i - context), i + context + 1).some(({ kind }) => kind !== "same"),
  );
  const made: (DiffLine | undefined)[] = [];
  lines.forEach((line, i) => {
    if (near[i]) made.push(line);
    else if (i > 0 && near[i - 1] && near.slice(i).some(Boolean)) made.push(undefined);
  });
  return made;
}
