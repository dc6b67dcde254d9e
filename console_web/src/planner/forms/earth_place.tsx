// A thing's place on the earth, shown and typed, where the mission has an origin.
import { earthDecimals, originOf, toEarth, toLocal } from "../model/earth";
import { moveEdits, placeOf } from "../model/operations";
import { edit, mission } from "../model/plan";
import type { Thing } from "../model/things";
import { NumberInput } from "./number_input";

export function EarthPlace({ thing }: { thing: Thing }) {
  const view = mission.value;
  const origin = originOf(view.raw);
  const at = placeOf(view, thing);
  if (!origin || !at) return null;
  const [latitude, longitude] = toEarth(origin, at[0], at[1]);
  const put = (to: readonly [number, number]): void => {
    const [north, east] = toLocal(origin, ...to);
    edit("Move", moveEdits(mission.peek(), new Map([[thing, [north, east, at[2]]]])), `earth ${thing}`);
  };
  const within = (least: number, most: number) => (value: number) =>
    value < least || value > most ? `must be from ${least} to ${most}` : "";
  return (
    <div class="field-block">
      <span class="field-label" title="By the mission's origin, WGS 84">
        On the earth
      </span>
      <div class="field-cells pair">
        <NumberInput
          name="Latitude"
          label="latitude"
          unit="deg"
          title="North is positive"
          value={earthDecimals(latitude)}
          refuse={within(-89, 89)}
          onGive={(value) => value !== undefined && put([value, longitude])}
        />
        <NumberInput
          name="Longitude"
          label="longitude"
          unit="deg"
          title="East is positive"
          value={earthDecimals(longitude)}
          refuse={within(-180, 180)}
          onGive={(value) => value !== undefined && put([latitude, value])}
        />
      </div>
    </div>
  );
}
