// The flight modes as the server's table names, letters and colours them.
import { Mode } from "../gen/bumpless_pb";
import { MODES } from "../gen/house";

export interface ModeLook {
  letter: string;
  name: string;
  key: "forward" | "reverse" | "hover" | "none";
}

export const FLIGHT_MODES: readonly (ModeLook & { colour: string })[] = MODES;
const NO_MODE: ModeLook & { colour: string } = {
  letter: "–",
  name: "No mode",
  key: "none",
  colour: "transparent",
};
const BY_NAME = new Map<string, (typeof MODES)[number]>(MODES.map((look) => [look.mode, look]));

/** A mode as JSON names it, "MODE_HOVER". */
export function modeNamed(name: string): ModeLook & { colour: string } {
  return BY_NAME.get(name) ?? NO_MODE;
}

export function modeLook(mode: Mode | undefined): ModeLook & { colour: string } {
  return mode === undefined ? NO_MODE : modeNamed(`MODE_${Mode[mode]}`);
}
