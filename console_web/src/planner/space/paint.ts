// The plan in space: water, bottom, zones, dock, way, and what will be flown.
import { colour, font } from "../../lib/theme";
import { text } from "../map/paint/words";
import { along, type Ned, niceStep, observationPoint } from "../model/geometry";
import { outlineThing } from "../model/things";
import { paintFunnel } from "./funnel";
import { paintRings } from "./held";
import { dockSize, floorOf, type SpaceScene } from "./scene";
import { type Ctx, type Face, faces, way } from "./strokes";
import { paintTerrain } from "./terrain";

const MODES: Record<string, string> = { F: "--mode-forward", R: "--mode-reverse", H: "--mode-hover" };
const FAN_SHOWN = 60;
const GRID_LINES = 12;

export function paintSpace(c: Ctx, s: SpaceScene): void {
  const floor = floorOf(s.view);
  if (s.depths) paintTerrain(c, s, s.depths);
  else paintFloor(c, s, floor);
  faces(c, s.lens, zoneFaces(s, floor));
  paintFence(c, s, floor);
  if (!s.stale) {
    c.globalAlpha = 0.16;
    for (const flight of s.flights.slice(0, FAN_SHOWN)) way(c, s.lens, trackOf(flight), "--trace", 1);
    c.globalAlpha = 1;
  }
  paintPlanned(c, s, floor);
  if (s.nominal) paintTrack(c, s, s.nominal.track);
  if (s.variant) {
    c.setLineDash([9, 4]);
    way(c, s.lens, trackOf(s.variant.track), "--reference", 2);
    c.setLineDash([]);
  }
  if (s.picked) way(c, s.lens, trackOf(s.picked), "--alarm", 2);
  if (s.view.dock && s.figures) paintFunnel(c, s, s.view.dock, s.figures);
  if (s.view.dock) paintRings(c, s, s.view.dock.at);
  if (s.view.dock) paintDock(c, s, s.view.dock);
  paintHull(
    c,
    s,
    s.view.start.at,
    s.view.start.heading,
    s.selected.includes("start") ? "--accent" : "--ink-2",
  );
  if (s.vehicle) paintHull(c, s, s.vehicle.at, s.vehicle.heading, "--good");
  paintPoints(c, s);
  paintCompass(c, s);
}

interface Columns {
  north_m: readonly number[];
  east_m: readonly number[];
  depth_m: readonly number[];
}

function trackOf({ north_m, east_m, depth_m }: Columns): Ned[] {
  return north_m.map((n, i) => [n, east_m[i] ?? 0, depth_m[i] ?? 0] as const);
}

function paintFloor(c: Ctx, s: SpaceScene, floor: number): void {
  const { at, distance } = s.lens.orbit;
  const step = niceStep(distance / GRID_LINES);
  const reach = (step * GRID_LINES) / 2;
  const [n0, e0] = [Math.round(at[0] / step) * step, Math.round(at[1] / step) * step];
  for (let k = -reach; k <= reach + 1e-9; k += step) {
    const axis = (value: number): string => (Math.abs(value) < step / 2 ? "--line-2" : "--grid");
    const ends = [e0 - reach, e0 + reach] as const;
    way(
      c,
      s.lens,
      [
        [n0 + k, ends[0], floor],
        [n0 + k, ends[1], floor],
      ],
      axis(n0 + k),
      1,
    );
    way(
      c,
      s.lens,
      [
        [n0 - reach, e0 + k, floor],
        [n0 + reach, e0 + k, floor],
      ],
      axis(e0 + k),
      1,
    );
  }
  const surface: Ned[] = [
    [n0 - reach, e0 - reach, 0],
    [n0 + reach, e0 - reach, 0],
    [n0 + reach, e0 + reach, 0],
    [n0 - reach, e0 + reach, 0],
  ];
  faces(c, s.lens, [{ places: surface, ink: "--trace", alpha: 0.05, edge: "--line-2" }]);
}

function zoneFaces(s: SpaceScene, floor: number): Face[] {
  return s.view.keepOut.flatMap(({ corners, from, to }, i) => {
    const on = s.selected.some((thing) => thing === outlineThing(i) || thing.startsWith(`corner:${i}.`));
    const [top, bottom] = [from, Math.min(to ?? floor, Math.max(floor, from))];
    const look = { ink: "--alarm", alpha: on ? 0.24 : 0.13, edge: "--alarm" };
    const cap = (depth: number): Face => ({ places: corners.map(([n, e]) => [n, e, depth]), ...look });
    const sides = corners.map(([n, e], k): Face => {
      const [bn, be] = corners[(k + 1) % corners.length] ?? [n, e];
      return {
        places: [
          [n, e, top],
          [bn, be, top],
          [bn, be, bottom],
          [n, e, bottom],
        ],
        ...look,
      };
    });
    return [cap(top), cap(bottom), ...sides];
  });
}

function paintFence(c: Ctx, s: SpaceScene, floor: number): void {
  const corners = s.view.keepIn;
  const [first] = corners ?? [];
  if (!corners || !first) return;
  c.setLineDash([10, 4]);
  for (const depth of [0, floor])
    way(
      c,
      s.lens,
      [...corners, first].map(([n, e]) => [n, e, depth] as const),
      "--reference",
      2,
    );
  c.setLineDash([]);
  for (const [n, e] of corners)
    way(
      c,
      s.lens,
      [
        [n, e, 0],
        [n, e, floor],
      ],
      "--reference",
      1,
    );
}

function paintPlanned(c: Ctx, s: SpaceScene, floor: number): void {
  const places = [s.view.start.at, ...s.view.legs.map(({ at }) => at)];
  c.globalAlpha = 0.5;
  way(
    c,
    s.lens,
    places.map(([n, e]) => [n, e, floor] as const),
    "--line-2",
    2,
  );
  if (places.length <= 80)
    for (const place of places) way(c, s.lens, [place, [place[0], place[1], floor]], "--line-2", 1);
  c.globalAlpha = 1;
  c.setLineDash([7, 5]);
  way(c, s.lens, places, "--ink-2", 1.5);
  c.setLineDash([]);
}

function paintTrack(c: Ctx, s: SpaceScene, track: Columns & { mode: readonly string[] }): void {
  const places = trackOf(track);
  c.globalAlpha = s.stale ? 0.3 : 1;
  let from = 0;
  for (let i = 1; i <= track.mode.length; i++) {
    if (i < track.mode.length && track.mode[i] === track.mode[from]) continue;
    way(c, s.lens, places.slice(from, i + 1), MODES[track.mode[from] ?? ""] ?? "--trace", 2.5);
    from = i;
  }
  c.globalAlpha = 1;
}

/** The dock as an open box, its mouth towards the approach; and the place before it. */
function paintDock(c: Ctx, s: SpaceScene, dock: NonNullable<SpaceScene["view"]["dock"]>): void {
  const { width, length } = dockSize(s.view);
  const on = s.selected.includes("dock");
  const ring = (back: number): Ned[] => {
    const [n, e, d] = along(dock.at, dock.heading, back);
    return (
      [
        [1, 1],
        [1, -1],
        [-1, -1],
        [-1, 1],
        [1, 1],
      ] as const
    ).map(([side, down]): Ned => {
      const [pn, pe] = along([n, e, d], dock.heading + 90, (side * width) / 2);
      return [pn, pe, d + (down * width) / 2];
    });
  };
  const [mouth, end] = [ring(0), ring(length)];
  faces(c, s.lens, [{ places: end.slice(0, 4), ink: "--warning", alpha: 0.25, edge: "" }]);
  for (const square of [mouth, end]) way(c, s.lens, square, "--warning", on ? 3 : 2);
  for (let i = 0; i < 4; i++) way(c, s.lens, [mouth[i] as Ned, end[i] as Ned], "--warning", on ? 3 : 1.5);
  const before = observationPoint(dock.at, dock.heading, dock.standoff);
  c.setLineDash([3, 3]);
  way(c, s.lens, [before, dock.at], "--mode-hover", 1.5);
  c.setLineDash([]);
  const seen = s.lens.see(dock.at);
  if (seen) text(c, "Dock", seen[0] + 12, seen[1] - 12, on ? "--ink" : "--ink-2", 600);
}

/** A dart as long as the vehicle, though never too small to be seen. */
function paintHull(c: Ctx, s: SpaceScene, at: Ned, heading: number, ink: string): void {
  const least = (26 * s.lens.orbit.distance) / s.lens.scale;
  const length = Math.max(s.length, least);
  const bow = along(at, heading, length / 2);
  const side = (turn: number): Ned => along(at, heading + turn, length * 0.42);
  const fin: Ned = [
    ...along(at, heading + 180, length / 2).slice(0, 2),
    at[2] - (length * 0.22) / s.lens.orbit.stretch,
  ] as unknown as Ned;
  const stern = along(at, heading + 180, length * 0.28);
  faces(c, s.lens, [
    { places: [bow, side(155), stern], ink, alpha: 0.8, edge: "--ink" },
    { places: [bow, side(-155), stern], ink, alpha: 0.8, edge: "--ink" },
    { places: [bow, stern, fin], ink, alpha: 0.6, edge: "--ink" },
  ]);
}

function paintPoints(c: Ctx, s: SpaceScene): void {
  const many = s.view.legs.length > 80;
  s.view.legs.forEach(({ at }, i) => {
    const seen = s.lens.see(at);
    if (!seen) return;
    const thing = `leg:${i}`;
    const [on, over] = [s.selected.includes(thing), s.hovered === thing];
    c.fillStyle = colour(on ? "--accent" : "--panel");
    c.strokeStyle = colour(on ? "--ink" : "--accent");
    c.lineWidth = 2;
    c.beginPath();
    c.arc(seen[0], seen[1], on || over ? 7 : 5, 0, 2 * Math.PI);
    c.fill();
    c.stroke();
    if (many && !on) return;
    const words = on ? `${i + 1}, ${at[2].toFixed(1)} m` : String(i + 1);
    text(c, words, seen[0] + 9, seen[1] - 7, on ? "--ink" : "--ink-2", on ? 700 : 600);
  });
}

/** Where north is, and the way the current flows. */
function paintCompass(c: Ctx, s: SpaceScene): void {
  const { azimuth, elevation } = s.lens.orbit;
  const [x, y, radius] = [34, s.size.height - 34, 22];
  const flat = Math.max(0.25, Math.sin(elevation));
  const tip = (heading: number, share: number): readonly [number, number] => [
    x + radius * share * Math.sin(heading - azimuth),
    y - radius * share * Math.cos(heading - azimuth) * flat,
  ];
  c.strokeStyle = colour("--line-2");
  c.lineWidth = 1;
  c.beginPath();
  c.ellipse(x, y, radius, radius * flat, 0, 0, 2 * Math.PI);
  c.stroke();
  c.font = font("--text-2xs", 700);
  c.fillStyle = colour("--ink-2");
  c.textAlign = "center";
  const [nx, ny] = tip(0, 1.35);
  c.fillText("N", nx, ny + 4);
  const [north, east] = s.view.current;
  if (Math.hypot(north, east) < 1e-6) return;
  const [tx, ty] = tip(Math.atan2(east, north), 1);
  c.strokeStyle = colour("--trace");
  c.lineWidth = 2.5;
  c.beginPath();
  c.moveTo(x, y);
  c.lineTo(tx, ty);
  c.stroke();
  c.beginPath();
  c.arc(tx, ty, 3.5, 0, 2 * Math.PI);
  c.fillStyle = colour("--trace");
  c.fill();
}
