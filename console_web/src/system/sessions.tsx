// Who is logged in, and the button that ends it.
import { ask } from "../api/client";
import { dateTime } from "../lib/format";
import { Panel } from "../ui/panel";
import { Listed } from "./listed";
import { refreshPeople, sessions } from "./resources";

export function Sessions() {
  const list = sessions.value;
  const end = async (session: string): Promise<void> => {
    await ask("delete", "/api/sessions/{session}", { path: { session } });
    refreshPeople();
  };
  return (
    <Panel title="Logged in" class="system-wide" scrolls>
      <Listed
        list={list}
        empty="Nobody is logged in."
        head={["Who", "From", "Since", "Last seen", "Ends unused"]}
        last="Log out"
        row={(one) => (
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
        )}
      />
    </Panel>
  );
}
