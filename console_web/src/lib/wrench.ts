// The six components of a generalised force.
import type { Wrench } from "../gen/bumpless_pb";

export const WRENCH_AXES = ["X", "Y", "Z", "K", "M", "N"] as const;
export type WrenchAxis = (typeof WRENCH_AXES)[number];
const FIELDS = { X: "xN", Y: "yN", Z: "zN", K: "kNm", M: "mNm", N: "nNm" } as const;

export function wrenchOf(wrench: Wrench | undefined, axis: WrenchAxis): number | null {
  return wrench ? wrench[FIELDS[axis]] : null;
}

export function axisUnit(axis: WrenchAxis): string {
  return FIELDS[axis].endsWith("Nm") ? "N·m" : "N";
}
