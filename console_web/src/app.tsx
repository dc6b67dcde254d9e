// The page: top line, command line, banner, and the view that the address names after "#".
import { useEffect, useState } from "preact/hooks";
import { Banner } from "./live/banner";
import { Header, VIEWS, type ViewId } from "./live/header";
import { LiveView } from "./live/live_view";
import { CommandBar } from "./missions/command_bar";
import { MissionsView } from "./missions/missions_view";
import { RunsView } from "./runs/runs_view";
import { draft } from "./weights/draft";
import { WeightsView } from "./weights/weights_view";

function viewOfAddress(): ViewId {
  const wanted = location.hash.slice(1).split("/")[0];
  return VIEWS.find(({ id }) => id === wanted)?.id ?? "live";
}

export function App() {
  const [view, setView] = useState(viewOfAddress);
  useEffect(() => {
    const follow = (): void => setView(viewOfAddress());
    addEventListener("hashchange", follow);
    return () => removeEventListener("hashchange", follow);
  }, []);
  const changes = draft.use().changeCount();
  return (
    <div class="app">
      <Header view={view} badge={changes} />
      <CommandBar />
      <Banner />
      <LiveView hidden={view !== "live"} />
      {view === "missions" && <MissionsView />}
      {view === "weights" && <WeightsView />}
      {view === "runs" && <RunsView />}
    </div>
  );
}
