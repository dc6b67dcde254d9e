// The 3-D scene: the server's page in a frame, with the camera presets above it.
import { useEffect, useState } from "preact/hooks";
import { request, type Refusal } from "../api/http";
import { onTheme, theme } from "../lib/theme";
import { useFrame } from "../stream/frame";
import { live } from "../stream/store";
import { linkNow } from "./link_state";

const CAMERAS = [
  { view: "follow", name: "Follow", about: "Behind the vehicle" },
  { view: "overview", name: "Overview", about: "Whole path and target" },
  { view: "top", name: "Top", about: "From above, north up" },
  { view: "target", name: "Target", about: "From the docking target" },
] as const;
type Camera = (typeof CAMERAS)[number]["view"];

export function Scene() {
  const [camera, setCamera] = useState<Camera>("follow");
  const [refused, setRefused] = useState<Refusal>();
  const choose = async (view: Camera): Promise<void> => {
    const answer = await request("POST", "api/scene/camera", { view });
    setRefused(answer.ok ? undefined : answer);
    if (answer.ok) setCamera(view);
  };
  return (
    <section class="panel scene" aria-label="3-D scene">
      <header class="panel-head">
        <h2>Scene</h2>
        <span class="unit">NED</span>
        <span class="grow" />
        <div class="segments" role="group" aria-label="Camera">
          {CAMERAS.map(({ view, name, about }) => (
            <button key={view} type="button" aria-pressed={camera === view} title={about} onClick={() => void choose(view)}>
              {name}
            </button>
          ))}
        </div>
      </header>
      <SceneFrame />
      {refused && <p class="scene-note" role="alert">Camera not changed: {refused.reason}</p>}
    </section>
  );
}

function SceneFrame() {
  useFrame();
  const [shade, setShade] = useState(theme());
  useEffect(() => onTheme(() => setShade(theme())), []);
  const look = linkNow().look;
  const seen = live.connection === "open" || live.lastFrame > 0;
  return (
    <div class="scene-frame" data-state={look === "live" || look === "waiting" ? "fresh" : "stale"}>
      {seen && <iframe src={`scene/?theme=${shade}`} title="3-D scene of vehicle, path and target" />}
      {look !== "live" && (
        <p class="scene-veil">
          {look === "waiting" ? "Waiting for the vehicle. Its first start compiles, which takes minutes." : "Not live"}
        </p>
      )}
    </div>
  );
}
