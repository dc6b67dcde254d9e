// Accounts: made, given another role or password, removed.
import { useSignal } from "@preact/signals";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { me } from "../api/resources";
import { dateTime } from "../lib/format";
import { DeleteButton } from "../ui/delete_button";
import { Panel } from "../ui/panel";
import { RefusalIn } from "../ui/refusal";
import { Field, Form, NewPassword } from "./form";
import { Listed } from "./listed";
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
      <Listed
        list={list}
        empty="Nobody has an account, so nobody has to log in. With the first account, an engineer's, everybody does."
        head={["Name", "Role", "Since", "Sessions", "Tokens"]}
        numbers={["Sessions", "Tokens"]}
        last="Remove"
        row={(user) => (
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
        )}
      />
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
    <Form name="New account" does="Make the account" submit={make} refused="Not made." refusal={refusal}>
      <Field label="Name" of={name} maxLength={40} verbatim autocomplete="off" />
      <NewPassword label="Password" of={password} />
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
    </Form>
  );
}
