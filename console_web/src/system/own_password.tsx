// One's own session: log out, and another password.
import { useSignal } from "@preact/signals";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { Panel } from "../ui/panel";
import { RefusalIn } from "../ui/refusal";

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
      <form
        class="system-form"
        aria-label="Change your password"
        onSubmit={(event) => {
          event.preventDefault();
          void change();
        }}
      >
        <label>
          Present password
          <input
            required
            type="password"
            autocomplete="current-password"
            value={old.value}
            onInput={(event) => {
              old.value = event.currentTarget.value;
            }}
          />
        </label>
        <label>
          New password
          <input
            required
            type="password"
            minLength={10}
            maxLength={200}
            autocomplete="new-password"
            value={fresh.value}
            onInput={(event) => {
              fresh.value = event.currentTarget.value;
            }}
          />
        </label>
        <button type="submit" class="action">
          Change it
        </button>
        {done.value && <p role="status">Changed. Your other sessions are over.</p>}
        <RefusalIn title="Not changed." of={refusal} />
      </form>
    </Panel>
  );
}
