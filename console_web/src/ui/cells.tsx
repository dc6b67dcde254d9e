// Named figures side by side.
import type { ComponentChildren } from "preact";
import { Term } from "../words/term";
import type { WordId } from "../words/words";
import "./cells.css";

export interface CellProps {
  name: string;
  value: string;
  unit?: string;
  about?: string;
  /** The word that explains it. */
  word?: WordId;
}

export function Cells({
  cells,
  class: look,
  children,
}: {
  cells: CellProps[];
  class?: string;
  children?: ComponentChildren;
}) {
  return (
    <dl class={`cells ${look ?? ""}`}>
      {cells.map(({ name, value, unit, about, word }) => (
        <div key={name} title={about}>
          <dt>{word ? <Term of={word}>{name}</Term> : name}</dt>
          <dd>
            <b class="num">{value}</b>
            {unit && <span class="unit"> {unit}</span>}
          </dd>
        </div>
      ))}
      {children}
    </dl>
  );
}
