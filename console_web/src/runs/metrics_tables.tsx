// The metrics of a run as the method's publication defines them, with units.
import type { Metrics, ModeMetrics } from "../api/types";
import { compact, fixed } from "../lib/format";
import { modeNamed } from "../lib/modes";
import { type CellProps, Cells } from "../ui/cells";
import { AlarmIcon, CheckIcon } from "../ui/icons";
import { ModeLetter } from "../ui/mode_mark";
import "../ui/table.css";
import "./metrics_tables.css";

export function MetricsTables({ metrics: m }: { metrics: Metrics }) {
  const violations = m.increment_violations + m.demand_step_violations;
  return (
    <div class="metrics">
      <Cells class="metrics-cells" cells={figures(m)}>
        <div title="Cycles in which a command or the demand stepped farther than allowed: must be 0">
          <dt>Proposition 1</dt>
          <dd class={violations ? "lost" : "good"}>
            {violations ? <AlarmIcon size={12} /> : <CheckIcon size={12} />} <b class="num">{violations}</b>
            <span class="unit">
              {violations
                ? ` violations: ${m.increment_violations} command, ${m.demand_step_violations} demand`
                : " violations"}
            </span>
          </dd>
        </div>
      </Cells>
      <Modes metrics={m} />
      <Switches metrics={m} />
      <Runtime metrics={m} />
    </div>
  );
}

function percent(share: number | null): number | null {
  return share === null ? null : 100 * share;
}

function figures(m: Metrics): CellProps[] {
  const step = "Largest step of the bound-normalised command around";
  return [
    { name: "RMS e_τ", value: fixed(m.residual_rms, 4), about: "RMS ||tau_d − tau_c|| over all cycles" },
    {
      name: "r_sat",
      value: fixed(percent(m.saturation_ratio), 1),
      unit: "%",
      about: "Share of cycles with a command at a bound",
    },
    { name: "d_u F→R", value: fixed(m.d_u_fr, 4), unit: "of bound", about: `${step} F to R` },
    { name: "d_u R→H", value: fixed(m.d_u_rh, 4), unit: "of bound", about: `${step} R to H` },
    {
      name: "Final range",
      value: fixed(m.final_range_m, 2),
      unit: "m",
      about: "Range to the observation point at the end",
    },
    {
      name: "Duration",
      value: fixed(m.duration_s, 1),
      unit: "s",
      about: `${m.cycles} control cycles in the log, ${m.missing_cycles} missing`,
    },
    {
      name: "Solved",
      value: fixed(percent(m.solved_ratio), 1),
      unit: "%",
      about: "Share of cycles whose allocation met its tolerance",
    },
  ];
}

const MODE_ROWS: { name: string; unit: string; of: (m: ModeMetrics) => string }[] = [
  { name: "Duration", unit: "s", of: (m) => fixed(m.duration_s, 1) },
  { name: "Mean surge speed", unit: "m/s", of: (m) => fixed(m.surge_speed_mean_mps, 3) },
  { name: "Depth RMS", unit: "m", of: (m) => fixed(m.depth_rms_m, 3) },
  { name: "Depth peak to peak", unit: "m", of: (m) => fixed(m.depth_peak_to_peak_m, 3) },
  { name: "Roll RMS", unit: "°", of: (m) => fixed(m.roll_rms_deg, 3) },
  { name: "Pitch RMS", unit: "°", of: (m) => fixed(m.pitch_rms_deg, 3) },
  { name: "Heading RMS", unit: "°", of: (m) => fixed(m.yaw_rms_deg, 3) },
  { name: "Residual RMS", unit: "", of: (m) => fixed(m.residual_rms, 4) },
];

function Modes({ metrics }: { metrics: Metrics }) {
  if (!metrics.modes.length) return null;
  return (
    <table class="table compact" aria-label="By mode">
      <thead>
        <tr>
          <th scope="col">By mode</th>
          {metrics.modes.map(({ mode }, index) => (
            <th key={index} scope="col" class="num">
              <ModeLetter mode={modeNamed(mode)} /> {modeNamed(mode).name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {MODE_ROWS.map(({ name, unit, of }) => (
          <tr key={name}>
            <th scope="row">
              {name} <span class="unit">{unit}</span>
            </th>
            {metrics.modes.map((mode, index) => (
              <td key={index} class="num">
                {of(mode)}
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Switches({ metrics }: { metrics: Metrics }) {
  if (!metrics.switches.length) return <p class="hint">No mode switch in this run.</p>;
  return (
    <table class="table compact" aria-label="Switches">
      <thead>
        <tr>
          <th scope="col">Switch</th>
          <th scope="col" class="num">
            at, s
          </th>
          <th scope="col" class="num">
            step, of bound
          </th>
          <th scope="col" class="num">
            step, °/rpm mixed
          </th>
        </tr>
      </thead>
      <tbody>
        {metrics.switches.map((s, index) => (
          <tr key={index}>
            <th scope="row">
              <ModeLetter mode={modeNamed(s.from_mode)} /> → <ModeLetter mode={modeNamed(s.to_mode)} />
            </th>
            <td class="num">{fixed(s.time_s, 2)}</td>
            <td class="num">{fixed(s.command_step_normalised, 4)}</td>
            <td class="num">{fixed(s.command_step_raw, 2)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Runtime({ metrics: m }: { metrics: Metrics }) {
  return (
    <table class="table compact" aria-label="Allocator's run time">
      <thead>
        <tr>
          <th scope="col">
            Solve time <span class="unit">µs</span>
          </th>
          <th scope="col" class="num">
            mean
          </th>
          <th scope="col" class="num">
            std
          </th>
          <th scope="col" class="num">
            p95
          </th>
          <th scope="col" class="num">
            max
          </th>
        </tr>
      </thead>
      <tbody>
        <tr>
          <th scope="row">per cycle</th>
          {[m.solve_time_mean_us, m.solve_time_std_us, m.solve_time_p95_us, m.solve_time_max_us].map(
            (value, index) => (
              <td key={index} class="num">
                {compact(value, 4)}
              </td>
            ),
          )}
        </tr>
      </tbody>
    </table>
  );
}
