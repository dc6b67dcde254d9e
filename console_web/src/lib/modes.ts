// The three flight modes: letter, name, colour. The same on every screen and plot.
import { Mode } from "../gen/bumpless_pb";

export interface ModeLook {
  letter: string;
  name: string;
  colour: string;
  key: "forward" | "reverse" | "hover" | "none";
}

const NO_MODE: ModeLook = { letter: "–", name: "No mode", colour: "#64748b", key: "none" };
const LOOKS: Partial<Record<Mode, ModeLook>> = {
  [Mode.FORWARD]: { letter: "F", name: "Forward", colour: "#3b82f6", key: "forward" },
  [Mode.REVERSE]: { letter: "R", name: "Reverse", colour: "#f59e0b", key: "reverse" },
  [Mode.HOVER]: { letter: "H", name: "Hover", colour: "#10b981", key: "hover" },
};

export function modeLook(mode: Mode | undefined): ModeLook {
  return (mode !== undefined && LOOKS[mode]) || NO_MODE;
}

export const FLIGHT_MODES = [Mode.FORWARD, Mode.REVERSE, Mode.HOVER].map((mode) => modeLook(mode));
