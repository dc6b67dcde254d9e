import { render } from "preact";
import "./base/tokens.css";
import "./gen/modes.css";
import "./base/base.css";
import "./base/parts.css";
import { refreshOnNews } from "./api/resources";
import { App } from "./shell/app";
import { connect } from "./stream/socket";
import { live } from "./stream/store";

const root = document.getElementById("console");
if (root) {
  refreshOnNews();
  connect(live);
  live.keepTime();
  render(<App />, root);
}
