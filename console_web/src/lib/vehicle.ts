// What the console knows of the vehicle's build, from the server or from the telemetry itself.
import { vehicle } from "../api/resources";
import { live } from "../stream/store";
import { WRENCH_AXES, type WrenchAxis } from "./wrench";

const WITHOUT_SWAY: readonly WrenchAxis[] = WRENCH_AXES.filter((axis) => axis !== "Y");

/** Components of the wrench that the vehicle can command, in the order X Y Z K M N. */
export function controllableAxes(): readonly WrenchAxis[] {
  const named = vehicle.value?.controllable;
  return named?.length ? WRENCH_AXES.filter((axis) => named.includes(axis)) : WITHOUT_SWAY;
}

export function actuatorNames(): string[] {
  return (
    live.latest("tlm/description")?.actuatorNames ??
    vehicle.value?.actuators?.map((actuator) => actuator.name) ??
    live.latest("tlm/actuators")?.actuators.map((actuator) => actuator.name) ??
    []
  );
}
