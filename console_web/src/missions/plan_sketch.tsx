// The mission's path from above: north up, east right, metres, with target and current.
import type { MissionDetail } from "../api/types";
import { fixed } from "../lib/format";
import { Empty } from "../ui/panel";
import "./plan_sketch.css";

type Point = readonly [number, number];
const WIDTH = 340;
const HEIGHT = 240;
const MARGIN = 26;

export function PlanSketch({ mission }: { mission: MissionDetail }) {
  const path = mission.path_ned_m;
  if (!path?.length) return <Empty>No path to draw.</Empty>;
  const target = mission.target?.position_ned_m;
  const hover = mission.target?.observation_point_ned_m;
  const points = [...path, ...(target ? [target] : []), ...(hover ? [hover] : [])];
  const toScreen = projection(points);
  const line = path
    .map((point) =>
      toScreen(point)
        .map((v) => v.toFixed(1))
        .join(","),
    )
    .join(" ");
  const [start] = path;
  return (
    <svg
      class="sketch"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      role="img"
      aria-label={`Plan from above: ${path.length} waypoints, north up`}
    >
      <Grid toScreen={toScreen} points={points} />
      <polyline points={line} class="sketch-path" />
      {path.map((point, index) => {
        const [x, y] = toScreen(point);
        return (
          <g key={index}>
            <circle cx={x} cy={y} r={index ? 3 : 5} class={index ? "sketch-way" : "sketch-start"} />
            <title>{`${index ? `Waypoint ${index}` : "Start"}: N ${fixed(point[0], 1)}, E ${fixed(point[1], 1)}, D ${fixed(point[2], 1)} m`}</title>
          </g>
        );
      })}
      {start && <Label at={toScreen(start)} text="start" />}
      {hover && <Marker at={toScreen(hover)} kind="hover" text="hover point" />}
      {target && <Marker at={toScreen(target)} kind="target" text="target" />}
      <Current ned={mission.current_ned_mps} />
      <g class="sketch-north" transform={`translate(${WIDTH - 16} 20)`}>
        <path d="M0 10V-8M-4 -3 0 -9 4 -3" />
        <text y="21" text-anchor="middle">
          N
        </text>
      </g>
    </svg>
  );
}

/** Equal scales for north and east, the whole plan in the middle. */
function projection(points: readonly (readonly number[])[]): (point: readonly number[]) => Point {
  const north = points.map((p) => p[0] ?? 0);
  const east = points.map((p) => p[1] ?? 0);
  const [n0, n1] = [Math.min(...north), Math.max(...north)];
  const [e0, e1] = [Math.min(...east), Math.max(...east)];
  const scale = Math.min(
    (WIDTH - 2 * MARGIN) / Math.max(e1 - e0, 4),
    (HEIGHT - 2 * MARGIN) / Math.max(n1 - n0, 4),
  );
  const [nm, em] = [(n0 + n1) / 2, (e0 + e1) / 2];
  return (p) => [WIDTH / 2 + ((p[1] ?? 0) - em) * scale, HEIGHT / 2 - ((p[0] ?? 0) - nm) * scale];
}

function Grid({
  toScreen,
  points,
}: {
  toScreen: (p: readonly number[]) => Point;
  points: readonly (readonly number[])[];
}) {
  const n0 = points[0]?.[0] ?? 0;
  const e0 = points[0]?.[1] ?? 0;
  const perMetre = toScreen([n0, e0 + 1])[0] - toScreen([n0, e0])[0];
  const step = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].find((s) => s * perMetre >= 40) ?? 2000;
  const [x0, y0] = toScreen([0, 0]);
  const gap = step * perMetre;
  const xs: number[] = [];
  const ys: number[] = [];
  for (let x = ((x0 % gap) + gap) % gap; x < WIDTH; x += gap) xs.push(x);
  for (let y = ((y0 % gap) + gap) % gap; y < HEIGHT; y += gap) ys.push(y);
  return (
    <g class="sketch-grid">
      {xs.map((x) => (
        <line key={`x${x}`} x1={x} x2={x} y1={0} y2={HEIGHT} />
      ))}
      {ys.map((y) => (
        <line key={`y${y}`} y1={y} y2={y} x1={0} x2={WIDTH} />
      ))}
      <text x={8} y={HEIGHT - 8}>{`grid ${step} m`}</text>
    </g>
  );
}

function Label({ at: [x, y], text }: { at: Point; text: string }) {
  const right = x > WIDTH - 80;
  return (
    <text class="sketch-text" x={right ? x - 8 : x + 8} y={y - 7} text-anchor={right ? "end" : "start"}>
      {text}
    </text>
  );
}

function Marker({ at: [x, y], kind, text }: { at: Point; kind: "hover" | "target"; text: string }) {
  const right = x > WIDTH - 80;
  return (
    <g class={`sketch-${kind}`} transform={`translate(${x.toFixed(1)} ${y.toFixed(1)})`}>
      {kind === "target" ? <path d="M-5 -5H5V5H-5Z" /> : <circle r="6" />}
      <text
        class="sketch-text"
        x={right ? -10 : 10}
        y={kind === "target" ? -7 : 15}
        text-anchor={right ? "end" : "start"}
      >
        {text}
      </text>
    </g>
  );
}

function Current({ ned }: { ned: readonly number[] | null | undefined }) {
  const [north = 0, east = 0] = ned ?? [];
  const speed = Math.hypot(north, east);
  if (speed < 1e-3) return null;
  const angle = (Math.atan2(east, north) * 180) / Math.PI;
  return (
    <g class="sketch-current" transform="translate(22 26)">
      <path d="M0 12V-11M-4.5 -6 0 -12 4.5 -6" transform={`rotate(${angle.toFixed(0)})`} />
      <text x="18" y="4">{`current ${fixed(speed, 2)} m/s`}</text>
    </g>
  );
}
