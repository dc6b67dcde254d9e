/** Rows of one flight; `zero`: what is added to the time that is drawn. NED in m, angles in degrees. */
export interface Flight3d {
  name?: string;
  /** "#rrggbb"; without, the track has its modes' colours. */
  colour?: string;
  time: ArrayLike<number>;
  position: number[][];
  attitude: number[][];
  mode?: string[];
  zero?: number;
  hull?: Hull3d;
}

export interface Hull3d {
  vertices: number[][];
  faces: number[][];
}

export interface Data3d {
  flights: Flight3d[];
  hull?: Hull3d | undefined;
  path?: number[][] | undefined;
  target?: { position: number[]; heading: number; station?: number[] | undefined } | undefined;
}

export interface Look3d {
  ground: string;
  grid: string;
  ink: string;
  faint: string;
  path: string;
  target: string;
  hull: string;
  font: string;
  modes: Record<string, string>;
}

export type Preset3d = "follow" | "overview" | "top";

export function rotation(roll: number, pitch: number, yaw: number): number[][];
export function rowAt(time: ArrayLike<number>, t: number): number;

export class View3d {
  constructor(canvas: HTMLCanvasElement, data: Data3d, look: Look3d);
  data: Data3d;
  look: Look3d;
  time: number;
  view(preset: Preset3d): void;
  draw(t: number): void;
}
