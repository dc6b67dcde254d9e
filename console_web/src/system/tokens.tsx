// Tokens of scripts: made, shown once, revoked.
import { useSignal } from "@preact/signals";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { me } from "../api/resources";
import { dateTime } from "../lib/format";
import { DeleteButton } from "../ui/delete_button";
import { Empty, Panel } from "../ui/panel";
import { RefusalIn } from "../ui/refusal";
import { refreshPeople, tokens } from "./resources";
import { type Role, RoleField } from "./roles";

export function Tokens() {
  const list = tokens.value;
  return (
    <Panel title="Tokens of scripts" class="system-wide">
      {list?.length === 0 && <Empty>No script has a token.</Empty>}
      {list && list.length > 0 && (
        <table class="table compact">
          <thead>
            <tr>
              <th scope="col">Name</th>
              <th scope="col">Of</th>
              <th scope="col">Role</th>
              <th scope="col">Since</th>
              <th scope="col">Until</th>
              <th scope="col">
                <span class="sr">Revoke</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {list.map((one) => (
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
            ))}
          </tbody>
        </table>
      )}
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
    <form
      class="system-form"
      aria-label="New token"
      onSubmit={(event) => {
        event.preventDefault();
        void make();
      }}
    >
      <label>
        Name
        <input
          required
          maxLength={60}
          placeholder="nightly"
          value={name.value}
          onInput={(event) => {
            name.value = event.currentTarget.value;
          }}
        />
      </label>
      <label>
        Days
        <input
          required
          type="number"
          min={1}
          max={3650}
          value={days.value}
          onInput={(event) => {
            days.value = event.currentTarget.value;
          }}
        />
      </label>
      <RoleField
        label="Role of the token"
        value={role.value}
        onChoose={(chosen) => {
          role.value = chosen;
        }}
      />
      <button type="submit" class="action">
        Make a token
      </button>
      {secret.value && (
        <p role="status">
          Copy it now, it is not shown again: <code class="code secret">{secret.value}</code>
        </p>
      )}
      <RefusalIn title="Not made." of={refusal} />
    </form>
  );
}
