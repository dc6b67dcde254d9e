// Accounts: made, given another role or password, removed.
import { useSignal } from "@preact/signals";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { me } from "../api/resources";
import { dateTime } from "../lib/format";
import { DeleteButton } from "../ui/delete_button";
import { Empty, Panel } from "../ui/panel";
import { RefusalIn } from "../ui/refusal";
import { refreshPeople, users } from "./resources";
import { type Role, RoleField } from "./roles";

export function Users() {
  const refusal = useSignal<Refusal | undefined>(undefined);
  const list = users.value;
  const change = async (name: string, body: { role?: Role; password?: string }): Promise<void> => {
    const answer = await ask("put", "/api/users/{name}", { path: { name }, body });
    refusal.value = answer.ok ? undefined : answer;
    refreshPeople();
  };
  return (
    <Panel title="Accounts" class="system-wide">
      {list?.length === 0 && (
        <Empty>
          Nobody has an account, so nobody has to log in. With the first account, an engineer's, everybody
          does.
        </Empty>
      )}
      {list && list.length > 0 && (
        <table class="table compact">
          <thead>
            <tr>
              <th scope="col">Name</th>
              <th scope="col">Role</th>
              <th scope="col">Since</th>
              <th scope="col" class="num">
                Sessions
              </th>
              <th scope="col" class="num">
                Tokens
              </th>
              <th scope="col">
                <span class="sr">Remove</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {list.map((user) => (
              <tr key={user.name}>
                <th scope="row">
                  {user.name} {user.name === me.value?.name && <span class="tag">you</span>}
                </th>
                <td>
                  <RoleField
                    small
                    label={`Role of ${user.name}`}
                    value={user.role}
                    onChoose={(role) => void change(user.name, { role })}
                  />
                </td>
                <td class="when">{dateTime(user.since)}</td>
                <td class="num">{user.sessions}</td>
                <td class="num">{user.tokens}</td>
                <td>
                  <DeleteButton
                    name={`Remove ${user.name}`}
                    holdMs={700}
                    remove={() => ask("delete", "/api/users/{name}", { path: { name: user.name } })}
                    after={async () => refreshPeople()}
                  />
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
      <RefusalIn title="Not changed." of={refusal} />
      <NewUser first={list?.length === 0} />
    </Panel>
  );
}

function NewUser({ first }: { first: boolean }) {
  const name = useSignal("");
  const password = useSignal("");
  const role = useSignal<Role>("operator");
  const refusal = useSignal<Refusal | undefined>(undefined);
  const make = async (): Promise<void> => {
    const body = {
      name: name.value,
      role: first ? ("engineer" as const) : role.value,
      password: password.value,
    };
    const answer = await ask("post", "/api/users", { body });
    refusal.value = answer.ok ? undefined : answer;
    if (!answer.ok) return;
    name.value = "";
    password.value = "";
    if (first) location.replace(`./login${location.hash}`);
    else refreshPeople();
  };
  return (
    <form
      class="system-form"
      aria-label="New account"
      autocomplete="off"
      onSubmit={(event) => {
        event.preventDefault();
        void make();
      }}
    >
      <label>
        Name
        <input
          required
          maxLength={40}
          autocapitalize="none"
          spellcheck={false}
          autocomplete="off"
          value={name.value}
          onInput={(event) => {
            name.value = event.currentTarget.value;
          }}
        />
      </label>
      <label>
        Password
        <input
          required
          type="password"
          minLength={10}
          maxLength={200}
          autocomplete="new-password"
          title="At least ten characters"
          value={password.value}
          onInput={(event) => {
            password.value = event.currentTarget.value;
          }}
        />
      </label>
      {first ? (
        <span class="muted">an engineer's</span>
      ) : (
        <RoleField
          label="Role"
          value={role.value}
          onChoose={(chosen) => {
            role.value = chosen;
          }}
        />
      )}
      <button type="submit" class="action">
        Make the account
      </button>
      <RefusalIn title="Not made." of={refusal} />
    </form>
  );
}
