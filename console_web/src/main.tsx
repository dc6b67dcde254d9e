import { render } from "preact";
import "uplot/dist/uPlot.min.css";
import "./styles/tokens.css";
import "./styles/base.css";
import "./styles/shell.css";
import "./styles/live.css";
import "./styles/views.css";
import { refreshOnNews } from "./api/resources";
import { App } from "./app";
import { startAgeTick } from "./stream/frame";
import { connect } from "./stream/socket";
import { live } from "./stream/store";

const root = document.getElementById("console");
if (root) {
  refreshOnNews();
  connect(live);
  startAgeTick();
  render(<App />, root);
}
