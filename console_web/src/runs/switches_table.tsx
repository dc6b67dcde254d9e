// Each mode switch: how far it stepped in the paper's window, and until it had settled.
import type { Metrics, SwitchMetrics } from "../api/types";
import { fixed } from "../lib/format";
import { modeNamed } from "../lib/modes";
import { ModeLetter } from "../ui/mode_mark";

const SETTLING = "From the switch until 15 s after its ramp's end, or to the next switch";
const SWITCH_COLUMNS: { name: string; about: string; of: (s: SwitchMetrics) => string }[] = [
  {
    name: "±2 s",
    about: "The paper's window: largest step of the commands over their bounds within 2 s of the switch",
    of: (s) => fixed(s.command_step_normalised, 4),
  },
  {
    name: "°/rpm",
    about: "The same in degrees and rpm mixed, as the paper prints it",
    of: (s) => fixed(s.command_step_raw, 2),
  },
  {
    name: "settling",
    about: `${SETTLING}: largest step of the commands over their bounds`,
    of: (s) => fixed(s.command_step_settling, 4),
  },
  {
    name: "N",
    about: `${SETTLING}: largest step of the plant's true force`,
    of: (s) => fixed(s.force_step_n, 3),
  },
  {
    name: "N·m",
    about: `${SETTLING}: largest step of the plant's true moment`,
    of: (s) => fixed(s.moment_step_nm, 3),
  },
  {
    name: "°/s²",
    about: `${SETTLING}: largest step of the true angular acceleration`,
    of: (s) => fixed(s.angular_acceleration_step_degps2, 2),
  },
];

export function SwitchesTable({ metrics }: { metrics: Metrics }) {
  if (!metrics.switches.length) return <p class="hint">No mode switch in this run.</p>;
  return (
    <table class="table compact" aria-label="Switches">
      <thead>
        <tr>
          <th scope="col">Switch</th>
          <th scope="col" class="num">
            at, s
          </th>
          {SWITCH_COLUMNS.map(({ name, about }) => (
            <th key={name} scope="col" class="num" title={about}>
              {name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {metrics.switches.map((s, index) => (
          <tr key={index}>
            <th scope="row">
              <ModeLetter mode={modeNamed(s.from_mode)} /> → <ModeLetter mode={modeNamed(s.to_mode)} />
            </th>
            <td class="num">{fixed(s.time_s, 2)}</td>
            {SWITCH_COLUMNS.map(({ name, of }) => (
              <td key={name} class="num">
                {of(s)}
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
