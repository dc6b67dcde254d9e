// Named figures side by side.
import type { ComponentChildren } from "preact";
import "./cells.css";

export interface CellProps {
  name: string;
  value: string;
  unit?: string;
  about?: string;
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
      {cells.map(({ name, value, unit, about }) => (
        <div key={name} title={about}>
          <dt>{name}</dt>
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
