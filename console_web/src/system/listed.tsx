// A table of people's things: its head, a row for each, and what is said when there are none.
import type { ComponentChildren } from "preact";
import { Empty } from "../ui/panel";

interface ListedProps<One> {
  list: readonly One[] | undefined;
  /** Said in its place when the list is empty. */
  empty: ComponentChildren;
  head: string[];
  /** Columns of numbers. */
  numbers?: string[];
  /** What the last column's button does; heard, not seen. */
  last: string;
  row: (one: One) => ComponentChildren;
}

export function Listed<One>({ list, empty, head, numbers = [], last, row }: ListedProps<One>) {
  if (!list) return null;
  if (list.length === 0) return <Empty>{empty}</Empty>;
  return (
    <table class="table compact">
      <thead>
        <tr>
          {head.map((name) => (
            <th key={name} scope="col" class={numbers.includes(name) ? "num" : undefined}>
              {name}
            </th>
          ))}
          <th scope="col">
            <span class="sr">{last}</span>
          </th>
        </tr>
      </thead>
      <tbody>{list.map(row)}</tbody>
    </table>
  );
}
