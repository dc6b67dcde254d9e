// Tokens of scripts: made, shown once, revoked.
import { useSignal } from "@preact/signals";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { me } from "../api/resources";
import { dateTime } from "../lib/format";
import { DeleteButton } from "../ui/delete_button";
import { Panel } from "../ui/panel";
import { Field, Form } from "./form";
import { Listed } from "./listed";
import { refreshPeople, tokens } from "./resources";
import { type Role, RoleField } from "./roles";

export function Tokens() {
  const list = tokens.value;
  return (
    <Panel title="Tokens of scripts" class="system-wide">
      <Listed
        list={list}
        empty="No script has a token."
        head={["Name", "Of", "Role", "Since", "Until"]}
        last="Revoke"
        row={(one) => (
          <tr key={one.id}>
            <th scope="row">{one.name}</th>
            <td>{one.user}</td>
            <td>{one.role}</td>
            <td class="when">{dateTime(one.since)}</td>
            <td class="when">{one.until ? dateTime(one.until) : "revoked"}</td>
            <td>
              <DeleteButton
                name={`Revoke ${one.name}`}
                holdMs={700}
                remove={() => ask("delete", "/api/tokens/{token}", { path: { token: one.id } })}
                after={async () => refreshPeople()}
              />
            </td>
          </tr>
        )}
      />
      {me.value?.accounts && <NewToken />}
    </Panel>
  );
}

function NewToken() {
  const name = useSignal("");
  const days = useSignal("30");
  const role = useSignal<Role>("operator");
  const secret = useSignal("");
  const refusal = useSignal<Refusal | undefined>(undefined);
  const make = async (): Promise<void> => {
    const body = { name: name.value, role: role.value, days: Number(days.value) };
    const answer = await ask("post", "/api/tokens", { body });
    refusal.value = answer.ok ? undefined : answer;
    if (!answer.ok) return;
    secret.value = answer.value.secret;
    name.value = "";
    refreshPeople();
  };
  return (
    <Form
      name="New token"
      does="Make a token"
      submit={make}
      refused="Not made."
      refusal={refusal}
      told={
        secret.value && (
          <p role="status">
            Copy it now, it is not shown again: <code class="code secret">{secret.value}</code>
          </p>
        )
      }
    >
      <Field label="Name" of={name} maxLength={60} placeholder="nightly" />
      <Field label="Days" of={days} type="number" min={1} max={3650} />
      <RoleField
        label="Role of the token"
        value={role.value}
        onChoose={(chosen) => {
          role.value = chosen;
        }}
      />
    </Form>
  );
}
