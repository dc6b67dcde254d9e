// Q, R, lambda and ramp of the three modes side by side: rows are parameters, columns are modes.
import { FLIGHT_MODES } from "../lib/modes";
import { actuatorNames, controllableAxes } from "../lib/vehicle";
import { axisUnit, WRENCH_AXES } from "../lib/wrench";
import { ModeLetter } from "../ui/mode_mark";
import { NumberField } from "./field";
import "./mode_table.css";
import { otherNumbers } from "./ranges";

interface Row {
  key: string;
  name: string;
  unit: string;
  about: string;
  integer?: boolean;
}

interface Block {
  title: string;
  about: string;
  rows: Row[];
}

function blocks(): Block[] {
  const axes = controllableAxes();
  const q = WRENCH_AXES.flatMap((axis, index): Row[] =>
    axes.includes(axis)
      ? [
          {
            key: `q_diagonal[${index}]`,
            name: `Q ${axis}`,
            unit: axisUnit(axis) === "N" ? "1/N²" : "1/(N·m)²",
            about: `Weight of the error in ${axis}`,
          },
        ]
      : [],
  );
  const r = actuatorNames().map(
    (name, index): Row => ({
      key: `r_diagonal[${index}]`,
      name: `R ${name}`,
      unit: "1",
      about: `Weight of the command of ${name}, over its bound`,
    }),
  );
  const rest: Row[] = [
    { key: "lambda", name: "λ", unit: "1", about: "Price of commands against wrench error" },
    {
      key: "ramp_cycles",
      name: "N_sw",
      unit: "cycles",
      about: "Length of the blend into this mode",
      integer: true,
    },
  ];
  const named = ["lambda", "ramp_cycles"];
  for (const { path, label, unit } of otherNumbers("forward", named)) {
    rest.push({ key: path.split(".")[1] as string, name: label, unit, about: label });
  }
  return [
    { title: "Q", about: "wrench error", rows: q },
    { title: "R", about: "commands", rows: r },
    { title: "λ and ramp", about: "", rows: rest },
  ];
}

export function ModeTable() {
  return (
    <table class="weights">
      <thead>
        <tr>
          <th scope="col" class="weights-name">
            Parameter
          </th>
          {FLIGHT_MODES.map((mode) => (
            <th key={mode.key} scope="col" class="weights-mode" data-mode={mode.key}>
              <ModeLetter mode={mode} /> {mode.name}
            </th>
          ))}
        </tr>
      </thead>
      {blocks().map((block) => (
        <tbody key={block.title}>
          {block.rows.map((row, index) => (
            <tr key={row.key} class={index === 0 ? "block-first" : undefined}>
              <th scope="row" title={row.about}>
                {row.name} {row.unit !== "1" && <span class="unit">{row.unit}</span>}
              </th>
              {FLIGHT_MODES.map((mode) => (
                <td key={mode.key} data-mode={mode.key}>
                  <NumberField
                    path={`${mode.key}.${row.key}`}
                    name={`${mode.name}: ${row.name}`}
                    integer={row.integer}
                  />
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      ))}
    </table>
  );
}
