// The metrics of a run as the method's publication defines them, with units.
import type { Metrics, ModeMetrics } from "../api/types";
import { compact, fixed } from "../lib/format";
import { modeNamed } from "../lib/modes";
import { type CellProps, Cells } from "../ui/cells";
import { AlarmIcon, CheckIcon } from "../ui/icons";
import { ModeLetter } from "../ui/mode_mark";
import "../ui/table.css";
import { EndTable } from "./end_table";
import "./metrics_tables.css";
import { SwitchesTable } from "./switches_table";

export function MetricsTables({ metrics: m }: { metrics: Metrics }) {
  const violations = m.increment_violations + m.demand_step_violations;
  return (
    <div class="metrics">
      {m.outcome && <EndTable outcome={m.outcome} />}
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
      <ByMode metrics={m} label="Error about the reference" about={TRACKING_ABOUT} rows={TRACKING_ROWS} />
      <ByMode metrics={m} label="By mode, RMS about the mean" about={MODE_ABOUT} rows={MODE_ROWS} />
      <SwitchesTable metrics={m} />
      <Runtime metrics={m} />
    </div>
  );
}

function percent(share: number | null): number | null {
  return share === null ? null : 100 * share;
}

function figures(m: Metrics): CellProps[] {
  const step = "Largest step of the bound-normalised command within 2 s of the switch";
  const late = "The same from the switch until 15 s after its ramp's end, or to the next switch";
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
    { name: "d_u F→R, settling", value: fixed(m.d_u_fr_settling, 4), unit: "of bound", about: late },
    { name: "d_u R→H, settling", value: fixed(m.d_u_rh_settling, 4), unit: "of bound", about: late },
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
      name: "Shaft energy",
      value: fixed(m.shaft_energy_j, 1),
      unit: "J",
      about: "Torque times speed of every screw, by the vehicle's model; nothing comes back",
    },
    {
      name: "Fin travel",
      value: fixed(m.fin_travel_deg, 0),
      unit: "°",
      about: "Way of all fins together, as measured",
    },
    {
      name: "Reversals",
      value: fixed(m.screw_reversals, 0),
      about: "Changes of a screw's sense of rotation; below 2 % of its largest speed it has none",
    },
    {
      name: "Solved",
      value: fixed(percent(m.solved_ratio), 1),
      unit: "%",
      about: "Share of cycles whose allocation met its tolerance",
    },
  ];
}

interface ModeRow {
  name: string;
  unit: string;
  of: (m: ModeMetrics) => string;
}

const both = (rms: number | null, worst: number | null, decimals: number): string =>
  `${fixed(rms, decimals)} / ${fixed(worst, decimals)}`;

const TRACKING_ABOUT = "Believed state minus reference: RMS about zero, and the largest magnitude";
const TRACKING_ROWS: ModeRow[] = [
  { name: "Depth", unit: "m", of: (m) => both(m.depth_error_rms_m, m.depth_error_max_m, 3) },
  {
    name: "Cross-track",
    unit: "m",
    of: (m) => both(m.cross_track_error_rms_m, m.cross_track_error_max_m, 3),
  },
  { name: "Heading", unit: "°", of: (m) => both(m.heading_error_rms_deg, m.heading_error_max_deg, 2) },
  { name: "Surge speed", unit: "m/s", of: (m) => both(m.speed_error_rms_mps, m.speed_error_max_mps, 3) },
];

const MODE_ABOUT =
  "The paper's figures: RMS about the mean of each stay in the mode, not about the reference";
const MODE_ROWS: ModeRow[] = [
  { name: "Duration", unit: "s", of: (m) => fixed(m.duration_s, 1) },
  { name: "Mean surge speed", unit: "m/s", of: (m) => fixed(m.surge_speed_mean_mps, 3) },
  { name: "Depth RMS", unit: "m", of: (m) => fixed(m.depth_rms_m, 3) },
  { name: "Depth peak to peak", unit: "m", of: (m) => fixed(m.depth_peak_to_peak_m, 3) },
  { name: "Roll RMS", unit: "°", of: (m) => fixed(m.roll_rms_deg, 3) },
  { name: "Pitch RMS", unit: "°", of: (m) => fixed(m.pitch_rms_deg, 3) },
  { name: "Heading RMS", unit: "°", of: (m) => fixed(m.yaw_rms_deg, 3) },
  { name: "Residual RMS", unit: "", of: (m) => fixed(m.residual_rms, 4) },
];

function ByMode({
  metrics,
  label,
  about,
  rows,
}: {
  metrics: Metrics;
  label: string;
  about: string;
  rows: ModeRow[];
}) {
  if (!metrics.modes.length) return null;
  return (
    <table class="table compact" aria-label={label} title={about}>
      <thead>
        <tr>
          <th scope="col">{label}</th>
          {metrics.modes.map(({ mode }, index) => (
            <th key={index} scope="col" class="num">
              <ModeLetter mode={modeNamed(mode)} /> {modeNamed(mode).name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map(({ name, unit, of }) => (
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
