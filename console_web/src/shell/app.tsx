// The page: top line, command line, banner, and the view that the address names.
import { SkipLink } from "../ui/main";
import "./app.css";
import { AlarmBar } from "../alarms/alarm_bar";
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
      <Views />
    </div>
  );
}
