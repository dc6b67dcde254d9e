// Mode weights and switching rules, edited as a draft and applied in one step.
import { useEffect } from "preact/hooks";
import { AheadPanel } from "../ahead/ahead_panel";
import { Revisions } from "../ahead/revisions";
import { presets } from "../api/resources";
import { href } from "../shell/address";
import { Main } from "../ui/main";
import { AgeChip, Empty, Panel } from "../ui/panel";
import { ApplyBar } from "./apply_bar";
import { draft } from "./draft";
import { ModeTable } from "./mode_table";
import { Presets } from "./presets";
import { BumplessFields, SupervisorFields } from "./supervisor_fields";
import "./weights_view.css";

function onKey(event: KeyboardEvent): void {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const key = event.key.toLowerCase();
  const redo = (key === "z" && event.shiftKey) || key === "y";
  if (key !== "z" && !redo) return;
  event.preventDefault();
  if (redo) draft.redo();
  else draft.undo();
}

/** What cannot be changed in flight, and where it can be tried. */
function NotHere() {
  return (
    <Panel title="Not tunable in flight">
      <p class="hint">
        Gains of the controller, limits of its demand, guidance, filters and the choice of allocator are fixed
        when a mission starts. The stability that was worked out for this vehicle holds for these gains, and a
        new one would meet integrals that the old one has filled.
      </p>
      <p class="hint">
        Try them before a flight with <a href={href("plan")}>What if in Plan</a>, which flies a mission with
        any parameter, or after one with “Fly again with other numbers” at its <a href={href("runs")}>run</a>.
      </p>
    </Panel>
  );
}

export function WeightsView() {
  useEffect(() => {
    addEventListener("keydown", onKey);
    void presets.refresh();
    return () => removeEventListener("keydown", onKey);
  }, []);
  const known = Object.keys(draft.active.value).length > 0;
  if (!known) {
    return (
      <Main name="Mode weights" class="view">
        <Panel title="Mode weights">
          <Empty>
            The vehicle has not said what it flies with. Its parameters appear here as soon as its node
            speaks.
          </Empty>
        </Panel>
      </Main>
    );
  }
  return (
    <Main name="Mode weights" class="view weights-view">
      <ApplyBar />
      <div class="weights-columns">
        <Panel title="Allocation by mode" class="weights-table" aside={<AgeChip topic="tlm/parameters" />}>
          <ModeTable />
        </Panel>
        <div class="column">
          <AheadPanel />
          <NotHere />
          <Panel title="Supervisor">
            <SupervisorFields />
          </Panel>
          <Panel title="Bumpless mechanisms">
            <BumplessFields />
          </Panel>
          <Panel title="Presets">
            <Presets />
          </Panel>
          <Revisions />
        </div>
      </div>
    </Main>
  );
}
