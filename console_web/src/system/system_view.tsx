// System: what was not taken as it came, who did what, and who may. Three pages under one name.
import { me } from "../api/resources";
import { address, go } from "../shell/address";
import { Main } from "../ui/main";
import { Panel } from "../ui/panel";
import { Segments } from "../ui/segments";
import "../ui/table.css";
import "../ui/facts.css";
import { AuditTable } from "./audit_table";
import { Diagnostics } from "./diagnostics";
import { People } from "./people";
import "./system_view.css";

const PAGES = [
  {
    value: "diagnostics",
    name: "Diagnostics",
    about: "What was ignored, late, dropped, malformed or repeated",
  },
  { value: "audit", name: "Audit", about: "Who asked for what, and what came of it" },
  { value: "people", name: "People", about: "Control, accounts, sessions and tokens" },
] as const;
type PageName = (typeof PAGES)[number]["value"];

export function SystemView({ hidden }: { hidden: boolean }) {
  const page: PageName = PAGES.find(({ value }) => value === address.value.id)?.value ?? "diagnostics";
  return (
    <Main name="System" class="view system" hidden={hidden}>
      <div class="system-head">
        <Segments name="Page" choices={PAGES} chosen={page} onChoose={(value) => go("system", value)} />
        <span class="grow" />
        <Mine />
      </div>
      {page === "diagnostics" && <Diagnostics />}
      {page === "audit" && (
        <Panel title="Audit" class="system-wide" scrolls>
          <AuditTable />
        </Panel>
      )}
      {page === "people" && <People />}
    </Main>
  );
}

/** Who looks, and with which rights. */
function Mine() {
  const who = me.value;
  if (!who) return null;
  return (
    <span class="muted">
      {who.accounts ? (
        <>
          Logged in as <strong>{who.shown}</strong>, {who.role}
        </>
      ) : (
        "Nobody logs in here: the console is reached from its own machine alone"
      )}
    </span>
  );
}
