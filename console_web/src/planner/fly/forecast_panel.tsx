// What will happen: with what chance the plan docks, when, at what cost, and how the others end.
import { clock, fixed } from "../../lib/format";
import { endingNamed } from "../../ui/endings";
import "../../ui/facts.css";
import { broken, dragging, flies } from "../model/plan";
import { Findings } from "./findings";
import { plan } from "./forecast";
import { type Chance, FLIGHTS, type Flight, type Forecast, othersIn, percent, worst } from "./foresight";
import "./forecast_panel.css";

const WORST_SHOWN = 5;

export function ForecastPanel({ onPlace }: { onPlace: () => void }) {
  const forecast = plan.forecast.value;
  const fresh = plan.current.value && !dragging.value;
  return (
    <section class="panel forecast" aria-label="Forecast">
      <header class="panel-head">
        <h2>Forecast</h2>
        <span class="grow" />
        <Working forecast={forecast} fresh={fresh} />
      </header>
      <div class="panel-body forecast-body" data-fresh={fresh ? "yes" : "no"}>
        {forecast && (forecast.nominal || forecast.chance) && <Odds forecast={forecast} />}
        <Findings onPlace={onPlace} />
        {forecast?.nominal && <Facts forecast={forecast} />}
        {forecast && forecast.flights.length > 0 && <Worst flights={forecast.flights} />}
        {!forecast && !broken.value && (
          <p class="empty">
            {flies.value
              ? "It is being flown ahead. The first answer takes a moment."
              : "The plan is flown ahead as soon as it has a way and a dock."}
          </p>
        )}
        {forecast?.state === "failed" && <p class="lost">It could not be flown ahead: {forecast.reason}</p>}
      </div>
    </section>
  );
}

function Working({ forecast, fresh }: { forecast: Forecast | undefined; fresh: boolean }) {
  const link = plan.line.link.value;
  if (link === "lost" || link === "closed")
    return (
      <span class="chip" data-look="offline" role="status">
        server away
      </span>
    );
  const done = forecast?.flights.length ?? 0;
  const busy = !fresh || forecast?.state === "flying";
  const words = !forecast
    ? ""
    : !fresh
      ? "flying ahead"
      : forecast.state === "flying"
        ? `${done} of ${forecast.of || FLIGHTS} flown`
        : "up to date";
  const latency = plan.line.latencyMs.value;
  return (
    <span
      class="hint num"
      role="status"
      aria-label="State of the forecast"
      data-busy={busy ? "yes" : "no"}
      title={latency === undefined ? undefined : `Track ${latency.toFixed(0)} ms after the last edit`}
    >
      {words}
    </span>
  );
}

function Odds({ forecast }: { forecast: Forecast }) {
  const { chance, nominal } = forecast;
  const ending = endingNamed(nominal?.outcome.ending);
  const docked = chance ? chance.docked / Math.max(1, chance.of) : 0;
  return (
    <div class="odds">
      {chance && chance.of > 0 ? (
        <>
          <p class="odds-line" role="status" aria-label="Chance">
            Docks in <b class="num">{chance.docked}</b> of <b class="num">{chance.of}</b>{" "}
            <span class="muted num">
              ({percent(chance.low)}–{percent(chance.high)} %)
            </span>
          </p>
          <OddsBar chance={chance} share={docked} />
          <p class="hint">{othersIn(chance) || "none ended otherwise"}</p>
        </>
      ) : (
        <p class="odds-line muted">Chance: flights are being drawn</p>
      )}
      {nominal && (
        <p class="nominal-line" title={nominal.outcome.reason}>
          {ending && (
            <span class="chip" data-look={ending.look}>
              <ending.Icon size={11} /> {ending.word}
            </span>
          )}
          <span class="muted">
            as planned{nominal.outcome.tries > 1 ? `, in ${nominal.outcome.tries} approaches` : ""}
          </span>
        </p>
      )}
    </div>
  );
}

function OddsBar({ chance, share }: { chance: Chance; share: number }) {
  const left = `${(chance.low * 100).toFixed(1)}%`;
  const width = `${((chance.high - chance.low) * 100).toFixed(1)}%`;
  return (
    <div
      class="odds-bar"
      aria-hidden="true"
      data-look={share >= 0.95 ? "good" : share >= 0.7 ? "fair" : "poor"}
    >
      <i style={{ width: `${(share * 100).toFixed(1)}%` }} />
      <em style={{ left, width }} />
    </div>
  );
}

function Facts({ forecast }: { forecast: Forecast }) {
  const { nominal } = forecast;
  if (!nominal) return null;
  const { margin } = nominal.track;
  const facts: [string, string, string][] = [
    [
      "In hover",
      nominal.arrival_s === null ? "never" : clock(nominal.arrival_s),
      "First time in hover, of the flight as planned",
    ],
    ["Way flown", `${fixed(nominal.length_m, 1)} m`, "Over ground"],
    ["Energy", `${fixed(nominal.energy_j, 0)} J`, "At the shafts"],
  ];
  if (margin.length > 0)
    facts.push([
      "Least margin",
      `${fixed(100 * Math.min(...margin), 0)} %`,
      "Share of the attainable forces that the demand leaves",
    ]);
  const clearance = nominal.least_clearance_m;
  if (clearance !== null && clearance !== undefined)
    facts.push([
      "Clearance",
      `${fixed(clearance, 1)} m`,
      "Least, from the hull down to the sea floor, as flown",
    ]);
  return (
    <dl class="facts forecast-facts">
      {facts.map(([name, value, about]) => (
        <div key={name} title={about}>
          <dt>{name}</dt>
          <dd class="num">{value}</dd>
        </div>
      ))}
    </dl>
  );
}

function Worst({ flights }: { flights: readonly Flight[] }) {
  const shown = worst(flights, WORST_SHOWN);
  const all = flights.length - flights.filter((flight) => flight.outcome === "docked").length;
  if (shown.length === 0) return null;
  return (
    <div class="worst">
      <h3 class="form-title">Worst flights{all > shown.length ? ` (${shown.length} of ${all})` : ""}</h3>
      <ul>
        {shown.map((flight) => (
          <li key={flight.seed}>
            <button
              type="button"
              class="worst-row"
              aria-pressed={plan.picked.value === flight.seed}
              title="Show its track"
              onClick={() => {
                plan.picked.value = plan.picked.peek() === flight.seed ? undefined : flight.seed;
              }}
            >
              <span>{endingNamed(flight.outcome)?.word ?? flight.outcome}</span>
              <span class="num">{fixed(flight.closest_m, 2)} m</span>
              <span class="muted num">seed {flight.seed}</span>
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}
