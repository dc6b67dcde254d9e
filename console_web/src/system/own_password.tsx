// One's own session: log out, and another password.
import { useSignal } from "@preact/signals";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { Panel } from "../ui/panel";
import { Field, Form, NewPassword } from "./form";

async function logOut(): Promise<void> {
  await ask("post", "/api/logout");
  location.replace("./login");
}

export function OwnPassword() {
  const old = useSignal("");
  const fresh = useSignal("");
  const done = useSignal(false);
  const refusal = useSignal<Refusal | undefined>(undefined);
  const change = async (): Promise<void> => {
    const answer = await ask("put", "/api/me/password", { body: { old: old.value, new: fresh.value } });
    refusal.value = answer.ok ? undefined : answer;
    done.value = answer.ok;
    old.value = "";
    fresh.value = "";
  };
  return (
    <Panel
      title="Your account"
      class="system-wide"
      aside={
        <button type="button" class="action small" onClick={() => void logOut()}>
          Log out
        </button>
      }
    >
      <Form
        name="Change your password"
        does="Change it"
        submit={change}
        refused="Not changed."
        refusal={refusal}
        told={done.value && <p role="status">Changed. Your other sessions are over.</p>}
      >
        <Field label="Present password" of={old} type="password" autocomplete="current-password" />
        <NewPassword label="New password" of={fresh} />
      </Form>
    </Panel>
  );
}
