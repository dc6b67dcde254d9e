// "What happens when", on the sheet before a start: as the vehicle's own file declares it.
import { vehicle } from "../api/resources";

// Whoever starts must know these of itself, also where the vehicle does nothing about them.
const ABOUT_PEOPLE = new Set(["heartbeat_lost", "holder_lost"]);

/** The causes that the vehicle acts on, and what it does without people; the rest it flies through, which is said. */
export function Failsafes() {
  const declared = vehicle.value?.failsafe ?? [];
  const told = declared.filter((one) => one.reaction !== "none" || ABOUT_PEOPLE.has(one.cause));
  const ignored = declared.filter((one) => !told.includes(one));
  if (declared.length === 0) return <span class="muted">the vehicle has not told</span>;
  return (
    <>
      <ul class="preflight-failsafes">
        {told.map((one) => (
          <li key={one.cause}>
            {one.when.replace(/\.$/, "")}
            {one.limit !== null && (
              <span class="num">
                {" "}
                ({one.limit} {one.unit})
              </span>
            )}
            : it {one.does}.
          </li>
        ))}
      </ul>
      {ignored.length > 0 && <span class="muted">Not watched: {ignored.map(words).join("; ")}.</span>}
    </>
  );
}

function words(one: { cause: string }): string {
  return one.cause.replaceAll("_", " ");
}
