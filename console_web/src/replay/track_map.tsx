// Where the vehicle was, seen from above: path, track in its modes' colours, vehicle, target.
import { Mode } from "../gen/bumpless_pb";
import { paintHeld } from "../lib/held_ring";
import { modeLook } from "../lib/modes";
import { colour, font, typeSize } from "../lib/theme";
import { heldNow } from "../live/station";
import { screen } from "../stream/screen";
import { Canvas } from "../ui/canvas";
import { Panel } from "../ui/panel";

const RING_PX = 46;
const EDGE_PX = 14; // kept free all round

type Point = [north: number, east: number];

export function TrackMap() {
  return (
    <Panel title="Track" unit="NED, from above" topic="tlm/navigation" class="track">
      <Canvas class="track-map" name="Track of the vehicle from above" paint={paint} />
    </Panel>
  );
}

function paint(g: CanvasRenderingContext2D, width: number, height: number): void {
  const path = (screen.latest("tlm/plan")?.pathNedM ?? []).map(({ x, y }): Point => [x, y]);
  const target = screen.latest("tlm/target");
  const marks = [target?.positionNedM, target?.observationPointNedM].flatMap((p): Point[] =>
    p ? [[p.x, p.y]] : [],
  );
  const [north, east] = [screen.history.column("north"), screen.history.column("east")];
  const end = screen.history.firstIndex(screen.until + 1e-6);
  const track: Point[] = [];
  for (let i = 0; i < screen.history.length; i++) {
    const point: Point = [north?.[i] ?? Number.NaN, east?.[i] ?? Number.NaN];
    if (Number.isFinite(point[0])) track.push(point);
  }
  const held = screen.isLive ? heldNow.value : undefined;
  const ring = held ? Math.min(RING_PX, height / 6) : 0;
  const at = framing([...path, ...marks, ...track], width, height, ring + EDGE_PX);
  if (!at) return;
  line(g, path.map(at), colour("--ink-2"), [4, 4]);
  let from = 0;
  for (let i = 1; i <= end; i++) {
    if (i < end && screen.history.mode[i] === screen.history.mode[from]) continue;
    const mode = screen.history.mode[from] as Mode;
    let points: [number, number][] = [];
    const ink = mode === Mode.UNSPECIFIED ? colour("--line-2") : modeLook(mode).colour;
    for (let k = from; k < Math.min(i + 1, end); k++) {
      if (Number.isFinite(north?.[k])) points.push(at([north?.[k] as number, east?.[k] as number]));
      else {
        line(g, points, ink); // what follows is no neighbour: it was put there, or nobody saw the way
        points = [];
      }
    }
    line(g, points, ink);
    from = i;
  }
  if (held && target?.positionNedM) {
    const [x, y] = at([target.positionNedM.x, target.positionNedM.y]);
    paintHeld(g, held, { x, y, radius: ring, turn: 0 });
  }
  for (const mark of marks) dot(g, at(mark), colour("--reference"));
  const nav = screen.latest("tlm/navigation");
  if (nav?.positionNedM) {
    vehicle(g, at([nav.positionNedM.x, nav.positionNedM.y]), nav.attitude?.yawDeg ?? 0);
  }
  g.fillStyle = colour("--ink-2");
  g.font = font("--text-2xs");
  g.fillText("N ↑", 6, 6 + typeSize.peek());
}

/** All of it in the picture, to one scale, north up. */
function framing(
  all: Point[],
  width: number,
  height: number,
  edge: number,
): ((p: Point) => [number, number]) | undefined {
  if (!all.length) return undefined;
  const norths = all.map(([n]) => n);
  const easts = all.map(([, e]) => e);
  const [n0, n1] = [Math.min(...norths), Math.max(...norths)];
  const [e0, e1] = [Math.min(...easts), Math.max(...easts)];
  const room = (size: number): number => Math.max(size / 2, size - 2 * edge);
  const scale = Math.min(room(width) / Math.max(e1 - e0, 4), room(height) / Math.max(n1 - n0, 4));
  return ([n, e]) => [width / 2 + (e - (e0 + e1) / 2) * scale, height / 2 - (n - (n0 + n1) / 2) * scale];
}

function line(
  g: CanvasRenderingContext2D,
  points: [number, number][],
  ink: string,
  dash: number[] = [],
): void {
  g.strokeStyle = ink;
  g.lineWidth = 2;
  g.setLineDash(dash);
  g.beginPath();
  for (const [x, y] of points) g.lineTo(x, y);
  g.stroke();
  g.setLineDash([]);
}

function dot(g: CanvasRenderingContext2D, [x, y]: [number, number], ink: string): void {
  g.fillStyle = ink;
  g.beginPath();
  g.arc(x, y, 4, 0, 2 * Math.PI);
  g.fill();
}

function vehicle(g: CanvasRenderingContext2D, [x, y]: [number, number], yawDeg: number): void {
  g.save();
  g.translate(x, y);
  g.rotate((yawDeg * Math.PI) / 180);
  g.fillStyle = colour("--ink");
  g.beginPath();
  g.moveTo(0, -11);
  g.lineTo(6, 8);
  g.lineTo(-6, 8);
  g.fill();
  g.restore();
}
