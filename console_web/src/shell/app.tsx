// The page: top line, command line, banner, and the view that the address names.
import { replay } from "../replay/current";
import { ReplayBar } from "../replay/replay_bar";
import { SkipLink } from "../ui/main";
import "./app.css";
import { AlarmBar } from "../alarms/alarm_bar";
import { Words } from "../words/words_loader";
import { Banner } from "./banner";
import { CommandBar } from "./command_bar";
import { Header } from "./header";
import { Views } from "./views";

export function App() {
  return (
    <div class="app">
      <SkipLink />
      <Header />
      <CommandBar />
      <Banner />
      <AlarmBar />
      {replay.value && <ReplayBar replay={replay.value} />}
      <Views />
      <Words />
    </div>
  );
}
