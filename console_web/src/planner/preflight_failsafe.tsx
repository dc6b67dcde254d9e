// "What happens when", on the sheet before a start: as the vehicle's own file declares it.
import { vehicle } from "../api/resources";

/** The causes that the vehicle acts on; the rest it flies through, which is said as well. */
export function Failsafes() {
  const declared = vehicle.value?.failsafe ?? [];
  const watched = declared.filter((one) => one.reaction !== "none");
  const ignored = declared.length - watched.length;
  if (declared.length === 0) return <span class="muted">the vehicle has not told</span>;
  return (
    <>
      <ul class="preflight-failsafes">
        {watched.map((one) => (
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
      {ignored > 0 && (
        <span class="muted">
          Not watched:{" "}
          {declared
            .filter((one) => one.reaction === "none")
            .map(words)
            .join("; ")}
          .
        </span>
      )}
    </>
  );
}

function words(one: { cause: string }): string {
  return one.cause.replaceAll("_", " ");
}
