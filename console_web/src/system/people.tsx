// Who holds control, and for engineers who may do what: accounts, sessions, tokens.
import { useEffect } from "preact/hooks";
import { tunes } from "../access/control";
import { ControlPanel } from "../access/control_panel";
import { me } from "../api/resources";
import { Empty, Panel } from "../ui/panel";
import { OwnPassword } from "./own_password";
import { refreshPeople } from "./resources";
import { Sessions } from "./sessions";
import { Tokens } from "./tokens";
import { Users } from "./users";

export function People() {
  const engineer = me.value !== undefined && tunes.value;
  useEffect(() => {
    if (engineer) refreshPeople();
  }, [engineer]);
  return (
    <>
      <Panel title="Control" class="system-wide">
        <ControlPanel />
      </Panel>
      {me.value?.accounts && <OwnPassword />}
      {engineer ? (
        <>
          <Users />
          <Sessions />
          <Tokens />
        </>
      ) : (
        <Panel title="Accounts">
          <Empty>Engineers see and change accounts here.</Empty>
        </Panel>
      )}
    </>
  );
}
