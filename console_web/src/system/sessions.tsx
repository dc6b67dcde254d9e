// Who is logged in, and the button that ends it.
import { ask } from "../api/client";
import { dateTime } from "../lib/format";
import { Empty, Panel } from "../ui/panel";
import { refreshPeople, sessions } from "./resources";

export function Sessions() {
  const list = sessions.value;
  const end = async (session: string): Promise<void> => {
    await ask("delete", "/api/sessions/{session}", { path: { session } });
    refreshPeople();
  };
  return (
    <Panel title="Logged in" class="system-wide" scrolls>
      {list?.length === 0 && <Empty>Nobody is logged in.</Empty>}
      {list && list.length > 0 && (
        <table class="table compact">
          <thead>
            <tr>
              <th scope="col">Who</th>
              <th scope="col">From</th>
              <th scope="col">Since</th>
              <th scope="col">Last seen</th>
              <th scope="col">Ends unused</th>
              <th scope="col">
                <span class="sr">Log out</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {list.map((one) => (
              <tr key={one.id}>
                <th scope="row">
                  {one.user} {one.mine && <span class="tag">this browser</span>}
                </th>
                <td class="code">{one.address}</td>
                <td class="when">{dateTime(one.since)}</td>
                <td class="when">{dateTime(one.seen)}</td>
                <td class="when">{dateTime(one.ends)}</td>
                <td>
                  <button
                    type="button"
                    class="action small"
                    aria-label={`Log ${one.user} out at ${one.address}`}
                    onClick={() => void end(one.id)}
                  >
                    Log out
                  </button>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </Panel>
  );
}
