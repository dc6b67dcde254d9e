// The 3-D scene: the server's page in a frame, with the camera presets above it. The frame stays while
// another view is shown, for it is slow to load; its page draws nothing while it cannot be seen.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { theme } from "../lib/theme";
import { link } from "../stream/link";
import { live } from "../stream/store";
import { Segments } from "../ui/segments";
import "./scene.css";

const CAMERAS = [
  { value: "follow", name: "Follow", about: "Behind the vehicle" },
  { value: "overview", name: "Overview", about: "Whole path and target" },
  { value: "top", name: "Top", about: "From above, north up" },
  { value: "target", name: "Target", about: "From the docking target" },
] as const;
/** This tab's own name: two tabs of one browser look from two places. */
const TAB = [...crypto.getRandomValues(new Uint8Array(6))]
  .map((n) => n.toString(16).padStart(2, "0"))
  .join("");
type Camera = (typeof CAMERAS)[number]["value"];

export function Scene({ hidden }: { hidden: boolean }) {
  const camera = useSignal<Camera>("follow");
  const ruler = useSignal(false);
  const refused = useSignal<{ what: string; refusal: Refusal } | undefined>(undefined);
  const choose = async (view: Camera): Promise<void> => {
    const answer = await ask("post", "/api/scene/camera", { body: { view, tab: TAB } });
    refused.value = answer.ok ? undefined : { what: "Camera not changed", refusal: answer };
    if (answer.ok) camera.value = view;
  };
  const rule = async (): Promise<void> => {
    const on = !ruler.value;
    const answer = await ask("post", "/api/scene/ruler", { body: { on, tab: TAB } });
    refused.value = answer.ok ? undefined : { what: "Ruler not changed", refusal: answer };
    if (answer.ok) ruler.value = on;
  };
  return (
    <section class="panel scene" aria-label="3-D scene" hidden={hidden}>
      <header class="panel-head">
        <h2>Scene</h2>
        <span class="unit">NED</span>
        <span class="grow" />
        <span class="segments">
          <button
            type="button"
            aria-pressed={ruler.value}
            title="From vehicle to dock; a click in the scene measures to what is clicked, the next one on from there"
            onClick={() => void rule()}
          >
            Ruler
          </button>
        </span>
        <Segments
          name="Camera"
          choices={CAMERAS}
          chosen={camera.value}
          onChoose={(view) => void choose(view)}
        />
      </header>
      <SceneFrame />
      {refused.value && (
        <p class="scene-note" role="alert">
          {refused.value.what}: {refused.value.refusal.reason}
        </p>
      )}
    </section>
  );
}

/** Its page came from our server: a browser's own page in its place, after a refusal, may not be looked into. */
function hasCome(frame: HTMLIFrameElement): boolean {
  try {
    return frame.contentDocument !== null;
  } catch {
    return false;
  }
}

function SceneFrame() {
  const { look } = link.value;
  const frame = useRef<HTMLIFrameElement>(null);
  const open = live.connection.value === "open";
  const seen = open || live.lastFrame > 0;
  const wanted = theme.value;
  const worn = useRef(wanted);
  if (open) worn.current = wanted; // while the server is away its page can't be had anew
  useEffect(() => {
    const shown = frame.current;
    if (open && shown && !hasCome(shown)) shown.setAttribute("src", shown.getAttribute("src") ?? "");
  }, [open]);
  return (
    <div class="scene-frame" data-state={look === "live" || look === "waiting" ? "fresh" : "stale"}>
      {seen && (
        <iframe
          ref={frame}
          src={`scene/${TAB}/?theme=${worn.current}`}
          title="3-D scene of vehicle, path and target"
        />
      )}
      {look !== "live" && (
        <p class="scene-veil">
          {look === "waiting"
            ? "Waiting for the vehicle. Its first start compiles, which takes minutes."
            : "Not live"}
        </p>
      )}
    </div>
  );
}
