// The metrics of a run as the method's publication defines them, with units.
import type { Metrics, ModeMetrics } from "../gen/bumpless_pb";
import { compact, fixed } from "../lib/format";
import { modeLook } from "../lib/modes";
import { AlarmIcon, CheckIcon } from "../ui/icons";

export function MetricsTables({ metrics: m }: { metrics: Metrics }) {
  const violations = m.incrementViolations + m.demandStepViolations;
  return (
    <div class="metrics">
      <dl class="cells metrics-cells">
        <Cell name="RMS e_τ" value={fixed(m.residualRms, 4)} unit="" about="RMS ||tau_d − tau_c|| over all cycles" />
        <Cell name="r_sat" value={fixed(100 * m.saturationRatio, 1)} unit="%" about="Share of cycles with a command at a bound" />
        <Cell name="d_u F→R" value={fixed(m.dUFr, 4)} unit="of bound" about="Largest step of the bound-normalised command around F to R" />
        <Cell name="d_u R→H" value={fixed(m.dURh, 4)} unit="of bound" about="Largest step of the bound-normalised command around R to H" />
        <Cell name="Final range" value={fixed(m.finalRangeM, 2)} unit="m" about="Range to the observation point at the end" />
        <Cell name="Duration" value={fixed(m.durationS, 1)} unit="s"
          about={`${m.cycles} control cycles in the log, ${m.missingCycles} missing`} />
        <Cell name="Solved" value={fixed(100 * m.solvedRatio, 1)} unit="%"
          about="Share of cycles whose allocation met its tolerance" />
        <div title="Cycles in which a command or the demand stepped farther than allowed: must be 0">
          <dt>Proposition 1</dt>
          <dd class={violations ? "lost" : "good"}>
            {violations ? <AlarmIcon size={12} /> : <CheckIcon size={12} />} <b class="num">{violations}</b>
            <span class="unit">
              {violations ? ` violations: ${m.incrementViolations} command, ${m.demandStepViolations} demand` : " violations"}
            </span>
          </dd>
        </div>
      </dl>
      <Modes metrics={m} />
      <Switches metrics={m} />
      <Runtime metrics={m} />
    </div>
  );
}

function Cell({ name, value, unit, about }: { name: string; value: string; unit: string; about: string }) {
  return (
    <div title={about}>
      <dt>{name}</dt>
      <dd><b class="num">{value}</b>{unit && <span class="unit"> {unit}</span>}</dd>
    </div>
  );
}

const MODE_ROWS: { name: string; unit: string; of: (m: ModeMetrics) => string }[] = [
  { name: "Duration", unit: "s", of: (m) => fixed(m.durationS, 1) },
  { name: "Mean surge speed", unit: "m/s", of: (m) => fixed(m.surgeSpeedMeanMps, 3) },
  { name: "Depth RMS", unit: "m", of: (m) => fixed(m.depthRmsM, 3) },
  { name: "Depth peak to peak", unit: "m", of: (m) => fixed(m.depthPeakToPeakM, 3) },
  { name: "Roll RMS", unit: "°", of: (m) => fixed(m.rollRmsDeg, 3) },
  { name: "Pitch RMS", unit: "°", of: (m) => fixed(m.pitchRmsDeg, 3) },
  { name: "Heading RMS", unit: "°", of: (m) => fixed(m.yawRmsDeg, 3) },
  { name: "Residual RMS", unit: "", of: (m) => fixed(m.residualRms, 4) },
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
              <span class="mode-letter" data-mode={modeLook(mode).key}>{modeLook(mode).letter}</span> {modeLook(mode).name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {MODE_ROWS.map(({ name, unit, of }) => (
          <tr key={name}>
            <th scope="row">{name} <span class="unit">{unit}</span></th>
            {metrics.modes.map((mode, index) => <td key={index} class="num">{of(mode)}</td>)}
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
          <th scope="col" class="num">at, s</th>
          <th scope="col" class="num">step, of bound</th>
          <th scope="col" class="num">step, °/rpm mixed</th>
        </tr>
      </thead>
      <tbody>
        {metrics.switches.map((s, index) => (
          <tr key={index}>
            <th scope="row">
              <span class="mode-letter" data-mode={modeLook(s.fromMode).key}>{modeLook(s.fromMode).letter}</span> →{" "}
              <span class="mode-letter" data-mode={modeLook(s.toMode).key}>{modeLook(s.toMode).letter}</span>
            </th>
            <td class="num">{fixed(s.timeS, 2)}</td>
            <td class="num">{fixed(s.commandStepNormalised, 4)}</td>
            <td class="num">{fixed(s.commandStepRaw, 2)}</td>
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
          <th scope="col">Solve time <span class="unit">µs</span></th>
          <th scope="col" class="num">mean</th>
          <th scope="col" class="num">std</th>
          <th scope="col" class="num">p95</th>
          <th scope="col" class="num">max</th>
        </tr>
      </thead>
      <tbody>
        <tr>
          <th scope="row">per cycle</th>
          {[m.solveTimeMeanUs, m.solveTimeStdUs, m.solveTimeP95Us, m.solveTimeMaxUs].map((value, index) => (
            <td key={index} class="num">{compact(value, 4)}</td>
          ))}
        </tr>
      </tbody>
    </table>
  );
}
