// The chosen mission: what it is for, its path from above, its file as written.
import { useEffect, useState } from "preact/hooks";
import { request, type Refusal } from "../api/http";
import { missions } from "../api/resources";
import type { MissionDetail } from "../api/types";
import { clock, fixed } from "../lib/format";
import { MissionPhase } from "../gen/bumpless_pb";
import { isFlying, linkNow, PHASES, phaseNow } from "../live/link_state";
import { useFrame } from "../stream/frame";
import { HoldButton } from "../ui/hold_button";
import { PlayIcon, TrashIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import { ProblemTable, RefusalNotice } from "../ui/refusal";
import { choose, commandState, startChosen } from "./commands";
import { PlanSketch } from "./plan_sketch";
import { YamlText } from "./yaml_text";

export function MissionDetails() {
  useFrame();
  const list = missions.use().value;
  const name = commandState.chosen || list?.[0]?.name || "";
  const hash = list?.find((mission) => mission.name === name)?.sha256;
  const [detail, setDetail] = useState<MissionDetail>();
  const [refusal, setRefusal] = useState<Refusal>();
  useEffect(() => {
    if (!name) return;
    let current = true;
    void request<MissionDetail>("GET", `api/missions/${encodeURIComponent(name)}`).then((answer) => {
      if (!current) return;
      setDetail(answer.ok ? answer.value : undefined);
      setRefusal(answer.ok ? undefined : answer);
    });
    return () => {
      current = false;
    };
  }, [name, hash]);

  if (refusal) return <Panel title="Mission"><Empty>It cannot be read: {refusal.reason}</Empty></Panel>;
  if (!detail) return <Panel title="Mission"><Empty>Choose a mission on the left to see its path and file.</Empty></Panel>;
  return (
    <div class="column">
      <Panel title={detail.title || detail.name} class="mission-about" aside={<StartHere name={detail.name} valid={detail.valid !== false} />}>
        <div class="about">
          <div class="about-text">
            <p>{detail.summary || "No summary."}</p>
            <dl class="facts">
              <div><dt>File</dt><dd class="code">{detail.name}</dd></div>
              <div><dt>Duration</dt><dd class="num">{clock(detail.duration_s)}</dd></div>
              <div><dt>Hash</dt><dd class="code" title={detail.sha256}>{detail.sha256?.slice(0, 12) ?? "–"}</dd></div>
              {detail.target && (
                <div><dt>Target NED</dt><dd class="num">{detail.target.position_ned_m.map((v) => fixed(v, 1)).join(", ")} m</dd></div>
              )}
            </dl>
            {detail.builtin === false && <Delete name={detail.name} />}
          </div>
          <PlanSketch mission={detail} />
        </div>
      </Panel>
      <Panel title="File" class="mission-file" aside={<span class="muted">read only</span>}>
        {detail.problems && detail.problems.length > 0 && <ProblemTable problems={detail.problems} />}
        <YamlText text={detail.yaml} />
      </Panel>
    </div>
  );
}

function StartHere({ name, valid }: { name: string; valid: boolean }) {
  useFrame();
  const phase = phaseNow();
  const look = linkNow().look;
  const ready = valid && look === "live" && !isFlying(phase) && phase !== MissionPhase.UNSPECIFIED;
  const why = !valid ? "The file breaks a rule" : look !== "live" ? "No live vehicle" : isFlying(phase) ? `Vehicle is ${PHASES[phase].toLowerCase()}` : "";
  return (
    <>
      {why && <span class="muted">{why}</span>}
      <button
        type="button"
        class="action primary"
        disabled={!ready || commandState.busy !== undefined}
        onClick={() => {
          choose(name);
          void startChosen();
        }}
      >
        <PlayIcon /> Start this mission
      </button>
    </>
  );
}

function Delete({ name }: { name: string }) {
  const [refusal, setRefusal] = useState<Refusal>();
  const remove = async (): Promise<void> => {
    const answer = await request("DELETE", `api/missions/${encodeURIComponent(name)}`);
    setRefusal(answer.ok ? undefined : answer);
    if (!answer.ok) return;
    choose("");
    await missions.refresh();
  };
  return (
    <>
      <HoldButton name={`Delete ${name}`} class="danger" holdMs={700} onHeld={() => void remove()}>
        <TrashIcon /> Hold to delete
      </HoldButton>
      {refusal && <RefusalNotice title="Not deleted." refusal={refusal} onClose={() => setRefusal(undefined)} />}
    </>
  );
}
