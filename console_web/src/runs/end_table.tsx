// Where the vehicle was when the run ended: by the truth, where known, and as it believed.
import type { EndErrors, Outcome } from "../api/types";
import { fixed } from "../lib/format";

const COLUMNS: { name: string; about: string; of: (e: EndErrors) => string }[] = [
  {
    name: "position, m",
    about: "3-D distance from the observation point",
    of: (e) => fixed(e.position_m, 3),
  },
  { name: "horizontal, m", about: "Its horizontal part", of: (e) => fixed(e.horizontal_m, 3) },
  { name: "depth, m", about: "Its vertical part, positive below", of: (e) => fixed(e.depth_m, 3) },
  { name: "heading, °", about: "From the approach heading", of: (e) => fixed(e.heading_deg, 2) },
  { name: "speed, m/s", about: "Over ground", of: (e) => fixed(e.speed_mps, 3) },
];

export function EndTable({ outcome }: { outcome: Outcome }) {
  const rows: [string, EndErrors | null][] = [
    ["true", outcome.true_errors],
    ["believed", outcome.believed_errors],
  ];
  return (
    <table class="table compact" aria-label="At the end">
      <thead>
        <tr>
          <th scope="col">At the end</th>
          {COLUMNS.map(({ name, about }) => (
            <th key={name} scope="col" class="num" title={about}>
              {name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map(([name, errors]) => (
          <tr key={name}>
            <th scope="row">{name}</th>
            {COLUMNS.map(({ name: column, of }) => (
              <td key={column} class="num">
                {errors ? of(errors) : "–"}
              </td>
            ))}
          </tr>
        ))}
        <tr title="Least distance of the hull's axis, nose to tail, from the marker">
          <th scope="row">closest</th>
          <td class="num">{fixed(outcome.closest_m, 3)}</td>
          <td colSpan={4}>
            <span class="unit">{`m to the marker, ${fixed(outcome.closest_s, 1)} s after the start`}</span>
          </td>
        </tr>
      </tbody>
    </table>
  );
}
