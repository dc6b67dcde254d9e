// The attainable force and moment sets: the margin in one number, and cuts through both, to a fixed scale.
import { fixed } from "../lib/format";
import { colour, font, typeSize } from "../lib/theme";
import { axisUnit, WRENCH_AXES, wrenchOf } from "../lib/wrench";
import { inForce, screen } from "../stream/screen";
import { Canvas } from "../ui/canvas";
import { Empty } from "../ui/panel";
import { Term } from "../words/term";
import { acts, marginOf, type Reach, reach, slice } from "./reach";

/** The two axes of each cut, as indices of X Y Z K M N. */
const CUTS = [
  [0, 2],
  [0, 1],
  [1, 2],
  [3, 4],
  [3, 5],
  [4, 5],
] as const;
const LOW = 0.2;

/** How a margin is to be taken. */
export function lookOf(margin: number | undefined): "good" | "warning" | "alarm" | "off" {
  if (margin === undefined) return "off";
  return margin <= 0 ? "alarm" : margin < LOW ? "warning" : "good";
}

export function presentMargin(): number | undefined {
  return inForce.value ? marginOf(screen.latest("tlm/control")?.demanded, reach.value) : undefined;
}

export function MarginLine() {
  const margin = presentMargin();
  const text = margin === undefined ? "–" : fixed(100 * margin, 0);
  return (
    <div class="margin-line" data-look={lookOf(margin)} role="group" aria-label={`Margin ${text} percent`}>
      <Term of="margin">margin</Term>
      <b class="num">{text} %</b>
      <span class="meter">
        <i style={{ width: `${100 * (margin ?? 0)}%` }} />
      </span>
      {margin === 0 && <span class="lost">the demand is outside what can be given</span>}
    </div>
  );
}

export function AttainableSets() {
  const control = screen.latest("tlm/control");
  if (!reach.value) return <Empty>The attainable sets appear once the vehicle has described itself.</Empty>;
  if (!control) return <Empty>Demand and answer appear with the first telemetry.</Empty>;
  return (
    <>
      <MarginLine />
      <div class="sets">
        {CUTS.filter((cut) => cut.every((axis) => (reach.value?.most[axis] ?? 0) > 0)).map(([a, b]) => (
          <Canvas
            key={`${a}${b}`}
            name={`Cut of the attainable set, ${WRENCH_AXES[a]} to the right, ${WRENCH_AXES[b]} upwards`}
            paint={(g, width, height) => paint(g, width, height, a, b)}
          />
        ))}
      </div>
      <p class="hint">
        <Term of="attainable">Cuts at the present demand</Term>, at {fixed(reach.value.surge_mps, 1)} m/s
        through the water
      </p>
    </>
  );
}

/** Demand and answer of one set's three axes. */
function parts(of: "demanded" | "achieved", first: number): number[] {
  const wrench = inForce.value ? screen.latest("tlm/control")?.[of] : undefined;
  return WRENCH_AXES.slice(first, first + 3).map((axis) => wrenchOf(wrench, axis) ?? Number.NaN);
}

/** The cut goes through the demand where it can, else through the nearest that the set has. */
function cutOf(of: Reach, base: number, i: number, j: number, demand: number): [number, number][] {
  const rows = base ? of.moment : of.force;
  for (const share of [1, 0.75, 0.5, 0.25]) {
    const cut = slice(rows, i, j, share * (Number.isFinite(demand) ? demand : 0));
    if (cut.length) return cut;
  }
  return slice(rows, i, j, 0);
}

function paint(g: CanvasRenderingContext2D, width: number, height: number, a: number, b: number): void {
  const now = reach.value;
  if (!now) return;
  const base = a < 3 ? 0 : 3;
  const [i, j] = [a - base, b - base];
  const demanded = parts("demanded", base);
  const achieved = parts("achieved", base);
  const [rightMost, upMost] = [now.most[a] || 1, now.most[b] || 1];
  const [cx, cy] = [width / 2, height / 2];
  const at = (x: number, y: number): [number, number] => [
    cx + Math.max(-1.2, Math.min(1.2, x / rightMost)) * 0.42 * width,
    cy - Math.max(-1.2, Math.min(1.2, y / upMost)) * 0.42 * height,
  ];
  g.strokeStyle = colour("--grid");
  g.beginPath();
  g.moveTo(0, cy);
  g.lineTo(width, cy);
  g.moveTo(cx, 0);
  g.lineTo(cx, height);
  g.stroke();
  g.beginPath();
  const cut = cutOf(now, base, i, j, demanded[3 - i - j] ?? 0);
  for (const [x, y] of cut) g.lineTo(...at(x * acts(now, a), y * acts(now, b)));
  g.closePath();
  g.fillStyle = colour("--accent-soft");
  g.strokeStyle = colour("--accent");
  g.fill();
  g.stroke();
  mark(g, at(achieved[i] as number, achieved[j] as number), "--trace", false);
  mark(g, at(demanded[i] as number, demanded[j] as number), "--reference", true);
  g.fillStyle = colour("--ink-2");
  g.font = font("--text-2xs");
  const [right, up] = [WRENCH_AXES[a] as "X", WRENCH_AXES[b] as "X"];
  g.textAlign = "right";
  g.fillText(`${right} ${fixed(rightMost, 1)} ${axisUnit(right)}`, width - 3, height - 4);
  g.textAlign = "left";
  g.fillText(`${up} ${fixed(upMost, 1)} ${axisUnit(up)}`, 3, typeSize.peek());
}

/** The demand as a cross, the answer as a dot: told apart without colour. */
function mark(g: CanvasRenderingContext2D, [x, y]: [number, number], ink: string, cross: boolean): void {
  if (!Number.isFinite(x + y)) return;
  g.strokeStyle = g.fillStyle = colour(ink);
  g.lineWidth = 2;
  g.beginPath();
  if (cross) {
    g.moveTo(x - 4, y - 4);
    g.lineTo(x + 4, y + 4);
    g.moveTo(x - 4, y + 4);
    g.lineTo(x + 4, y - 4);
    g.stroke();
  } else {
    g.arc(x, y, 3, 0, 2 * Math.PI);
    g.fill();
  }
  g.lineWidth = 1;
}
