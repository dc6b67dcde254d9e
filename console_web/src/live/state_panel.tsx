// Where the vehicle is and how it follows its path, in numbers.
import type { Guidance } from "../gen/bumpless_pb";
import { fixed, headingOf, signed } from "../lib/format";
import { inForce, screen } from "../stream/screen";
import { Cells } from "../ui/cells";
import { Empty, Panel } from "../ui/panel";
import type { WordId } from "../words/words";

export function StatePanel() {
  return (
    <Panel title="State" topic="tlm/navigation" unit="NED" class="state-panel">
      <Figures />
    </Panel>
  );
}

function Figures() {
  const nav = screen.latest("tlm/navigation");
  const guidance = inForce.value ? screen.latest("tlm/guidance") : undefined; // else nothing is followed
  if (!nav) return <Empty>The vehicle's estimate appears with the first telemetry.</Empty>;
  const current = nav.currentEstimateNedMps;
  const cells: [string, string, string, WordId?][] = [
    ["North", fixed(nav.positionNedM?.x, 1), "m"],
    ["East", fixed(nav.positionNedM?.y, 1), "m"],
    ["Depth", fixed(nav.depthM, 2), "m"],
    ["Heading", headingOf(nav.attitude?.yawDeg, 1), "°"],
    ["Roll", signed(nav.attitude?.rollDeg, 1), "°"],
    ["Pitch", signed(nav.attitude?.pitchDeg, 1), "°"],
    ["Speed", fixed(nav.speedOverGroundMps, 2), "m/s"],
    ["Current", fixed(current && Math.hypot(current.x, current.y), 2), "m/s", "current"],
    ["Cross-track", signed(guidance?.crossTrackErrorM, 2), "m", "cross_track"],
    ["Leg", legText(guidance), "", "leg"],
  ];
  return (
    <Cells
      cells={cells.map(([name, value, unit, word]) => ({ name, value, unit, ...(word ? { word } : {}) }))}
    />
  );
}

/** "2/3"; after a missed approach the vehicle is on its way back, which is no leg of the mission. */
function legText(guidance: Guidance | undefined): string {
  if (!guidance?.legCount) return "–";
  return guidance.leg >= guidance.legCount ? "back" : `${guidance.leg + 1}/${guidance.legCount}`;
}
