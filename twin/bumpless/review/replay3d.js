// A small 3-D view of flights on a plain canvas: no library, no WebGL, nothing fetched. The report has it inside,
// and the console shows replays and comparisons with it. Positions are NED in m, angles in degrees.

const RAD = Math.PI / 180;
const FOV = 42 * RAD;
const NEAR = 0.1;

/** Rotation body to NED of Euler zyx angles, row by row. Source: Fossen 2021, ch. 2. */
export function rotation(roll, pitch, yaw) {
  const [cf, sf, ct, st, cp, sp] = [roll, pitch, yaw].flatMap((a) => [Math.cos(a * RAD), Math.sin(a * RAD)]);
  return [
    [cp * ct, cp * st * sf - sp * cf, cp * st * cf + sp * sf],
    [sp * ct, sp * st * sf + cp * cf, sp * st * cf - cp * sf],
    [-st, ct * sf, ct * cf],
  ];
}

const times = (m, [x, y, z]) => m.map(([a, b, c]) => a * x + b * y + c * z);
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a) => {
  const size = Math.hypot(...a) || 1;
  return a.map((v) => v / size);
};

/** Index of the last row at or before a time; 0 before the first. */
export function rowAt(time, t) {
  let [low, high] = [0, time.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (time[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** Pose of a flight at a time, between its rows; held before its first and after its last. */
export function poseAt(flight, t) {
  const i = rowAt(flight.time, t);
  const k = Math.min(i + 1, flight.time.length - 1);
  const span = flight.time[k] - flight.time[i];
  const f = span > 0 ? Math.min(1, Math.max(0, (t - flight.time[i]) / span)) : 0;
  const mix = (row, other, j) => row[j] + f * (other[j] - row[j]);
  const turn = (a, b) => a + f * ((((b - a + 180) % 360) + 360) % 360 - 180);
  const [p, q, a, b] = [flight.position[i], flight.position[k], flight.attitude[i], flight.attitude[k]];
  return { position: [0, 1, 2].map((j) => mix(p, q, j)), attitude: [0, 1, 2].map((j) => turn(a[j], b[j])), row: i };
}

/** The view: `data` is {flights, hull, path, target}, `look` the colours. Nothing is drawn before `draw`. */
export class View3d {
  constructor(canvas, data, look) {
    this.canvas = canvas;
    this.data = data;
    this.look = look;
    this.time = 0;
    this.preset = "follow";
    this.turn = [150, 22]; // bearing from which is looked, and height above the horizon
    this.distance = 6;
    this.onTurn = () => {};
    this.pointers();
  }

  /** "follow", "overview" or "top". */
  view(preset) {
    this.preset = preset;
    const [low, high] = this.bounds();
    const size = Math.max(4, Math.hypot(high[0] - low[0], high[1] - low[1]));
    this.turn = preset === "top" ? [180, 89.9] : [150, preset === "follow" ? 22 : 35];
    this.distance = preset === "follow" ? 6 : 0.5 * size / Math.tan(FOV / 2);
    this.draw(this.time);
  }

  bounds() {
    const all = [...this.data.flights.flatMap((flight) => flight.position), ...(this.data.path ?? [])];
    if (this.data.target) all.push(this.data.target.position);
    const finite = all.filter((p) => p.every(Number.isFinite));
    if (!finite.length) return [[-1, -1, 0], [1, 1, 1]];
    return [Math.min, Math.max].map((pick) => [0, 1, 2].map((j) => finite.reduce((m, p) => pick(m, p[j]), finite[0][j])));
  }

  pointers() {
    let from;
    this.canvas.addEventListener("pointerdown", (event) => {
      from = [event.clientX, event.clientY];
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (!from) return;
      this.rotate((event.clientX - from[0]) * 0.4, (event.clientY - from[1]) * 0.4);
      from = [event.clientX, event.clientY];
    });
    for (const name of ["pointerup", "pointercancel"]) this.canvas.addEventListener(name, () => (from = undefined));
    this.canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.001));
    }, { passive: false });
    this.canvas.addEventListener("keydown", (event) => {
      const act = { ArrowLeft: [-8, 0], ArrowRight: [8, 0], ArrowUp: [0, 6], ArrowDown: [0, -6] }[event.key];
      if (act) this.rotate(...act);
      else if (event.key === "+") this.zoom(0.85);
      else if (event.key === "-") this.zoom(1.18);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }

  rotate(bearing, height) {
    this.turn = [this.turn[0] + bearing, Math.min(89.9, Math.max(-30, this.turn[1] + height))];
    this.draw(this.time);
  }

  zoom(factor) {
    this.distance = Math.min(2000, Math.max(0.8, this.distance * factor));
    this.draw(this.time);
  }

  /** Draw the moment `t`: of each flight in its own time, which `flight.zero` shifts. */
  draw(t) {
    this.time = t;
    const { canvas } = this;
    const scale = globalThis.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const g = canvas.getContext("2d");
    if (!g || !width || !height) return;
    if (canvas.width !== Math.round(width * scale)) canvas.width = Math.round(width * scale);
    if (canvas.height !== Math.round(height * scale)) canvas.height = Math.round(height * scale);
    g.setTransform(scale, 0, 0, scale, 0, 0);
    g.fillStyle = this.look.ground;
    g.fillRect(0, 0, width, height);
    const poses = this.data.flights.map((flight) => poseAt(flight, t + (flight.zero ?? 0)));
    const [low, high] = this.bounds();
    const aim = this.preset === "follow" && poses[0] ? poses[0].position : low.map((v, j) => (v + high[j]) / 2);
    const project = this.camera(aim, width, height);
    this.grid(g, project, low, high);
    this.line(g, project, this.data.path ?? [], this.look.path, 1.2, [5, 5]);
    this.target(g, project);
    this.data.flights.forEach((flight, k) => {
      this.track(g, project, flight, poses[k].row);
      this.hull(g, project, flight, poses[k], k > 0);
    });
    this.words(g, poses, t, width);
  }

  camera(aim, width, height) {
    const [bearing, tilt] = this.turn.map((a) => a * RAD);
    const away = [Math.cos(tilt) * Math.cos(bearing), Math.cos(tilt) * Math.sin(bearing), -Math.sin(tilt)];
    const eye = aim.map((v, j) => v + this.distance * away[j]);
    const ahead = unit(minus(aim, eye));
    const right = unit(cross([0, 0, 1], ahead));
    const down = cross(ahead, right);
    const focal = height / 2 / Math.tan(FOV / 2);
    this.eye = eye;
    return (point) => {
      const from = minus(point, eye);
      const depth = dot(from, ahead);
      if (depth < NEAR) return undefined;
      return [width / 2 + (focal * dot(from, right)) / depth, height / 2 + (focal * dot(from, down)) / depth, depth];
    };
  }

  line(g, project, points, ink, thick, dash = []) {
    g.strokeStyle = ink;
    g.lineWidth = thick;
    g.setLineDash(dash);
    g.beginPath();
    let open = false;
    for (const point of points) {
      const at = point.every(Number.isFinite) ? project(point) : undefined;
      if (!at) open = false;
      else if (open) g.lineTo(at[0], at[1]);
      else {
        g.moveTo(at[0], at[1]);
        open = true;
      }
    }
    g.stroke();
    g.setLineDash([]);
  }

  /** A measuring plane under everything, a line each metre or ten. */
  grid(g, project, low, high) {
    const floor = Math.ceil(high[2] + 1);
    const size = Math.max(high[0] - low[0], high[1] - low[1]) + 8;
    const step = size > 80 ? 10 : size > 30 ? 5 : 1;
    const [n0, e0] = [low[0] - 4, low[1] - 4].map((v) => Math.floor(v / step) * step);
    const [n1, e1] = [high[0] + 4, high[1] + 4].map((v) => Math.ceil(v / step) * step);
    const steps = (from, to) => Array.from({ length: Math.round((to - from) / step) + 1 }, (_, i) => from + i * step);
    for (const n of steps(n0, n1)) {
      this.line(g, project, steps(e0, e1).map((e) => [n, e, floor]), this.look.grid, 0.7);
    }
    for (const e of steps(e0, e1)) {
      this.line(g, project, steps(n0, n1).map((n) => [n, e, floor]), this.look.grid, 0.7);
    }
    const north = project([n1, (e0 + e1) / 2, floor]);
    g.fillStyle = this.look.ink;
    const words = 18 + 16 * Math.max(1, this.data.flights.length); // what stands at the top keeps its room
    if (north) g.fillText(`N · grid ${step} m, ${floor} m deep`, north[0], Math.max(words, north[1]));
  }

  target(g, project) {
    const { target } = this.data;
    if (!target) return;
    const [n, e, d] = target.position;
    const [c, s] = [Math.cos(target.heading * RAD), Math.sin(target.heading * RAD)];
    const at = (aside, up) => [n - s * aside, e + c * aside, d - up];
    this.line(g, project, [at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5), at(-0.5, -0.5)], this.look.target, 2);
    if (target.station) {
      const [x, y, z] = target.station;
      this.line(g, project, [[x - 0.2, y, z], [x + 0.2, y, z]], this.look.target, 2);
      this.line(g, project, [[x, y - 0.2, z], [x, y + 0.2, z]], this.look.target, 2);
    }
  }

  /** What was flown up to now in the modes' colours or the flight's own, the rest faint. */
  track(g, project, flight, row) {
    this.line(g, project, flight.position, this.look.faint, 1);
    let from = 0;
    for (let i = 1; i <= row; i++) {
      if (i < row && (flight.colour || flight.mode?.[i] === flight.mode?.[from])) continue;
      const ink = flight.colour ?? this.look.modes[flight.mode?.[from]] ?? this.look.ink;
      this.line(g, project, flight.position.slice(from, i + 1), ink, 2.4);
      from = i;
    }
  }

  hull(g, project, flight, { position, attitude }, ghost) {
    const hull = flight.hull ?? this.data.hull;
    if (!hull || !position.every(Number.isFinite)) return;
    const turned = rotation(...attitude);
    const points = hull.vertices.map((v) => times(turned, v).map((x, j) => x + position[j]));
    const seen = points.map(project);
    const faces = hull.faces
      .filter((face) => face.every((i) => seen[i]))
      .map((face) => ({ face, depth: face.reduce((sum, i) => sum + seen[i][2], 0) }))
      .sort((a, b) => b.depth - a.depth);
    g.globalAlpha = ghost ? 0.45 : 1;
    for (const { face } of faces) {
      const [a, b, c] = face.map((i) => points[i]);
      const normal = unit(cross(minus(b, a), minus(c, a)));
      const light = 0.55 + 0.45 * Math.abs(dot(normal, [0.35, 0.25, -0.9]));
      g.fillStyle = shaded(flight.colour ?? this.look.hull, light);
      g.beginPath();
      for (const i of face) g.lineTo(seen[i][0], seen[i][1]);
      g.fill();
    }
    g.globalAlpha = 1;
  }

  words(g, poses, t, width) {
    g.fillStyle = this.look.ink;
    g.font = this.look.font;
    this.data.flights.forEach((flight, k) => {
      const depth = poses[k].position[2].toFixed(2);
      const mode = flight.mode?.[poses[k].row] ?? "";
      g.fillText(`${flight.name ?? ""} ${mode} ${depth} m deep`.trim(), 8, 18 + 16 * k);
    });
    const told = `T+${t.toFixed(1)} s`;
    g.fillText(told, width - g.measureText(told).width - 8, 18);
  }
}

/** "#rrggbb" by a share of its brightness. */
function shaded(colour, share) {
  const part = (i) => Math.round(Number.parseInt(colour.slice(i, i + 2), 16) * share);
  return /^#[0-9a-f]{6}$/i.test(colour) ? `rgb(${part(1)} ${part(3)} ${part(5)})` : colour;
}
