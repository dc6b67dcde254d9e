// The little that counts, large enough to be read from three metres.
import { useEffect } from "preact/hooks";
import { alarms, unseen } from "../alarms/alarms";
import { lookOf as lookOfAlarm } from "../alarms/looks";
import { clock, fixed, headingOf } from "../lib/format";
import { modeLook } from "../lib/modes";
import { link } from "../stream/link";
import { PHASES } from "../stream/phase";
import { inForce, screen, shownMode, shownPhase } from "../stream/screen";
import { ModeBadge } from "../ui/mode_mark";
import { lookOf, presentMargin } from "./attainable";
import { trackingErrors } from "./errors";
import "./wall.css";
import { watchReach } from "./reach";

interface Figure {
  name: string;
  value: string;
  unit: string;
  look?: string;
}

export function Wall() {
  useEffect(watchReach, []);
  const mode = modeLook(inForce.value ? shownMode.value : undefined);
  const status = screen.latest("tlm/mission");
  const stale = !screen.isFresh("tlm/navigation");
  const worst = unseen.value[0] ?? alarms.value[0];
  const of = worst && lookOfAlarm(worst);
  return (
    <div class="wall" data-state={stale ? "stale" : "fresh"}>
      <div class="wall-mode">
        <ModeBadge mode={mode} />
        <strong>{mode.name}</strong>
        <span class="wall-phase">
          {PHASES[shownPhase.value]}
          {inForce.value && <span class="num"> T+{clock(status?.elapsedS)}</span>}
        </span>
      </div>
      <dl class="wall-figures">
        {figures().map(({ name, value, unit, look }) => (
          <div key={name} data-look={look}>
            <dt>{name}</dt>
            <dd>
              <b class="num">{value}</b> <span>{unit}</span>
            </dd>
          </div>
        ))}
      </dl>
      <p class="wall-note" data-look={of?.look ?? link.value.look}>
        {of && <of.Icon size={28} />}{" "}
        {worst
          ? `${worst.text}${worst.returnedNs ? " (over, not seen)" : ""}`
          : stale
            ? link.value.label
            : "No alarm."}
      </p>
    </div>
  );
}

function figures(): Figure[] {
  const nav = screen.latest("tlm/navigation");
  const margin = presentMargin();
  const errors = trackingErrors();
  const worst = errors.reduce((a, b) => (share(b) > share(a) ? b : a));
  const off = share(worst);
  return [
    { name: "Depth", value: fixed(nav?.depthM, 1), unit: "m" },
    {
      name: "To go",
      value: fixed(inForce.value ? screen.latest("tlm/supervisor")?.rangeM : NaN, 1),
      unit: "m",
    },
    { name: "Speed", value: fixed(nav?.speedOverGroundMps, 2), unit: "m/s" },
    { name: "Heading", value: headingOf(nav?.attitude?.yawDeg, 0), unit: "°" },
    {
      name: off >= 1 ? `${worst.name} off by` : "Following",
      value: off < 0 ? "–" : off >= 1 ? fixed(Math.abs(worst.error), worst.decimals) : "yes",
      unit: off >= 1 ? worst.unit : "",
      look: off >= 1 ? "alarm" : "good",
    },
    {
      name: "Margin",
      value: margin === undefined ? "–" : fixed(100 * margin, 0),
      unit: "%",
      look: lookOf(margin),
    },
  ];
}

/** Of its limit; -1 while nothing is followed. */
function share({ error, limit }: { error: number; limit: number }): number {
  const of = Math.abs(error) / limit;
  return Number.isFinite(of) ? of : -1;
}
