// A past switch, opened: what was true, what would have prevented it, the ramp, and the steps it cost beside the
// last run's.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { ask } from "../api/client";
import { runs } from "../api/resources";
import type { Event } from "../gen/bumpless_pb";
import { fixed } from "../lib/format";
import { colour, font, typeSize } from "../lib/theme";
import { WRENCH_AXES } from "../lib/wrench";
import { screen } from "../stream/screen";
import { Canvas } from "../ui/canvas";
import { Term } from "../words/term";
import { commandStep, type Ramp, rampOf } from "./switch_ramp";

export function SwitchFacts({ event }: { event: Event }) {
  const { unless, dwelt_s, dwell_s, range_m, detected } = event.details;
  void screen.tick;
  const at = Number(event.stamp?.timeNs ?? 0n) / 1e9;
  const ramp = rampOf(event);
  return (
    <>
      <dl class="switch-facts">
        <dt>would have been prevented by</dt>
        <dd>{unless ?? "not told"}</dd>
        <dt>stayed before</dt>
        <dd class="num">
          {dwelt_s ?? "–"} s of {dwell_s ?? "–"} s
        </dd>
        <dt>range, target</dt>
        <dd class="num">
          {range_m ?? "–"} m, {detected === "true" ? "seen" : "not seen"}
        </dd>
        <dt>
          <Term of="step">step of the commands</Term>
        </dt>
        <dd class="num">
          {fixed(commandStep(at), 4)} <LastRun event={event} />
        </dd>
      </dl>
      {ramp && (
        <Canvas
          class="switch-ramp"
          name="Transition factor and weights through the ramp"
          paint={(g, width, height) => paint(g, width, height, ramp)}
        />
      )}
    </>
  );
}

/** The same switch in the newest run that is over. */
function LastRun({ event }: { event: Event }) {
  const told = useSignal("");
  const last = runs.value?.find(
    ({ id, state, outcome }) =>
      state === "complete" && outcome && !id.startsWith(screen.latest("tlm/mission")?.runId || "?"),
  )?.id;
  const [from, to] = [event.details.from?.toUpperCase(), event.details.to?.toUpperCase()];
  useEffect(() => {
    told.value = "";
    if (!last) return;
    void ask("get", "/api/runs/{run}/metrics", { path: { run: last } }).then((answer) => {
      if (!answer.ok) return;
      const same = answer.value.switches.find(
        (s) => String(s.from_mode) === `MODE_${from}` && String(s.to_mode) === `MODE_${to}`,
      );
      told.value = same ? `, last run's ${fixed(same.command_step_normalised, 4)}` : ", not in the last run";
    });
  }, [last, from, to]);
  return (
    <span class="muted" title={last}>
      {told.value}
    </span>
  );
}

function paint(g: CanvasRenderingContext2D, width: number, height: number, ramp: Ramp): void {
  const text = 1.1 * typeSize.peek();
  const x = (t: number): number => ((t - ramp.from) / (ramp.to - ramp.from)) * width;
  const y = (share: number): number => height - 2 - share * (height - text - 4);
  g.font = font("--text-2xs");
  const line = (points: readonly [number, number][], ink: string, dash: number[] = []): void => {
    g.strokeStyle = ink;
    g.lineWidth = 1.5;
    g.setLineDash(dash);
    g.beginPath();
    for (const [t, v] of points) g.lineTo(x(t), y(v));
    g.stroke();
    g.setLineDash([]);
  };
  line(ramp.kappa, colour("--ink"));
  ramp.weights.forEach(({ axis, points }, k) => {
    line(points, colour(`--run-${(axis % 6) + 1}`), [[], [6, 3], [2, 2], [8, 2, 2, 2], [4, 4], [1, 3]][axis]);
    g.fillStyle = colour(`--run-${(axis % 6) + 1}`);
    g.fillText(`Q ${WRENCH_AXES[axis]}`, 24 + k * 2.6 * text, text - 2);
  });
  g.fillStyle = colour("--ink");
  g.fillText("κ", 4, text - 2);
}
