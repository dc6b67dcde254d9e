// Two texts as one change.

/** The smallest replacement that makes one text the other; undefined when they are equal. */
export function difference(
  from: string,
  to: string,
): { from: number; to: number; insert: string } | undefined {
  if (from === to) return undefined;
  let a = 0;
  while (a < from.length && a < to.length && from[a] === to[a]) a++;
  let [b, c] = [from.length, to.length];
  while (b > a && c > a && from[b - 1] === to[c - 1]) [b, c] = [b - 1, c - 1];
  return { from: a, to: b, insert: to.slice(a, c) };
}
