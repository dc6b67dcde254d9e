// Plan: one mission drawn, typed and flown ahead. Left the plan and its depth, right what will happen and the details.
import { signal, untracked, useSignal, useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { missions } from "../api/resources";
import { go } from "../shell/address";
import { Main } from "../ui/main";
import { Segments } from "../ui/segments";
import { charts, followCharts } from "./charts/charts";
import { ChartsPanel } from "./charts/charts_panel";
import { plan } from "./fly/forecast";
import { ForecastPanel } from "./fly/forecast_panel";
import { WhatIf } from "./fly/what_if_panel";
import { fields } from "./forms/fields";
import { LegsTable } from "./forms/legs_table";
import { SelectedForm } from "./forms/selected_form";
import { KEYS, onAnyKey, onClipboard } from "./keys";
import { Library } from "./library/library_panel";
import { learn, learnVehicles, vehicle, vehicles } from "./map/figures";
import { PlanMap } from "./map/plan_map";
import { copyOnEdit } from "./model/copy_on_edit";
import { autosave, name, named, openMission } from "./model/library";
import { broken, dragging, flies, mission, selected } from "./model/plan";
import { PlanBar } from "./plan_bar";
import { Preflight } from "./preflight";
import { Profile } from "./profile/profile";
import { YamlEditor } from "./text/yaml_editor";
import { Timeline } from "./timeline/timeline";
import { Versions } from "./versions";
import "./planner_view.css";

type Tab = "form" | "legs" | "text" | "if" | "charts" | "keys";
const tab = signal<Tab>("form");
const TABS: readonly { value: Tab; name: string; about: string }[] = [
  { value: "form", name: "Details", about: "Every number of what is selected, or of the mission" },
  { value: "legs", name: "Legs", about: "Length, time and depth rate of each leg" },
  { value: "text", name: "YAML", about: "The file itself" },
  { value: "if", name: "What if", about: "Another current, vehicle or tuning beside the plan" },
  { value: "charts", name: "Charts", about: "Overlays and depths beneath the plan" },
  { value: "keys", name: "Keys", about: "What the keyboard does" },
];

export function PlannerView({ hidden }: { hidden: boolean }) {
  const library = useSignal(named() === "");
  useEffect(() => {
    void missions.refresh();
    void learnVehicles();
    const stops = [
      copyOnEdit(),
      autosave(),
      followCharts(),
      plan.follow(() => name.value !== "" && !broken.value && flies.value),
    ];
    for (const kind of ["copy", "cut", "paste"] as const) document.addEventListener(kind, onClipboard);
    document.addEventListener("keydown", onAnyKey);
    return () => {
      for (const stop of stops) stop();
      for (const kind of ["copy", "cut", "paste"] as const) document.removeEventListener(kind, onClipboard);
      document.removeEventListener("keydown", onAnyKey);
    };
  }, []);
  useSignalEffect(() => {
    if (!dragging.value) void learn(mission.value.vehicle);
  });
  useSignalEffect(() => {
    const wanted = named();
    untracked(() => {
      if (wanted && wanted !== name.peek()) void openMission(wanted);
      else if (!wanted && name.peek()) go("plan", name.peek(), {}, true); // back by the tab
    });
  });
  useSignalEffect(() => {
    library.value = name.value === "" && named() === "";
  });
  const close = (): void => {
    library.value = false;
  };
  return (
    <Main name="Plan" class="view planner" hidden={hidden}>
      <PlanBar
        open={library.value}
        onOpen={() => {
          library.value = !library.peek();
        }}
      />
      <div class="planner-body">
        <div class="column planner-left" inert={library.value}>
          <PlanMap />
          <Profile />
          <Timeline />
        </div>
        <div class="column planner-right" data-tab={tab.value} inert={library.value}>
          <ForecastPanel onPlace={() => undefined} />
          <Details />
        </div>
        {library.value && <Library onClose={close} />}
      </div>
      <Preflight />
      <Versions />
      <datalist id="plan-grids">
        {charts.value
          ?.filter(({ kind }) => kind === "depths")
          .map(({ name: grid }) => (
            <option key={grid} value={grid} />
          ))}
      </datalist>
      <datalist id="plan-actuators">
        {vehicle.value?.actuators.map((id) => (
          <option key={id} value={id} />
        ))}
      </datalist>
      <datalist id="plan-vehicles">
        {vehicles.value.map((id) => (
          <option key={id} value={id} />
        ))}
      </datalist>
    </Main>
  );
}

function Details() {
  // Asked for here so that completion has them before the form was opened.
  void fields.value;
  const here = tab.value;
  useSignalEffect(() => {
    if (selected.value.length > 0 && tab.peek() === "keys") tab.value = "form";
  });
  return (
    <section class="panel details" aria-label="Details">
      <header class="panel-head">
        <Segments
          name="What is shown"
          choices={TABS}
          chosen={here}
          onChoose={(value) => {
            tab.value = value;
          }}
        />
      </header>
      <div class="details-body" data-tab={here} role="group" aria-label="What is chosen" tabIndex={0}>
        {!name.value ? null : here === "form" ? (
          <SelectedForm />
        ) : here === "legs" ? (
          <LegsTable />
        ) : here === "text" ? (
          <YamlEditor />
        ) : here === "if" ? (
          <WhatIf />
        ) : here === "charts" ? (
          <ChartsPanel />
        ) : (
          <Keys />
        )}
      </div>
    </section>
  );
}

function Keys() {
  return (
    <dl class="keys">
      {KEYS.map(([keys, what]) => (
        <div key={keys}>
          <dt class="code">{keys}</dt>
          <dd>{what}</dd>
        </div>
      ))}
    </dl>
  );
}
