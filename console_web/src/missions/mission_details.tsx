// The chosen mission: what it is for, its path from above, its file as written.
import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { barred } from "../access/control";
import { ask } from "../api/client";
import type { Answer } from "../api/http";
import { missions } from "../api/resources";
import type { MissionDetail } from "../api/types";
import { MissionPhase } from "../gen/bumpless_pb";
import { clock, fixed } from "../lib/format";
import { go } from "../shell/address";
import { choosing, chosen, seedRefused, mission as shown, startShown, waits } from "../shell/commands";
import { flying, link, PHASES, phase } from "../stream/link";
import { foreign } from "../stream/present";
import { ActButton } from "../ui/act_button";
import { DeleteButton } from "../ui/delete_button";
import { PlayIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import { ProblemTable } from "../ui/refusal";
import "../ui/facts.css";
import "./mission_details.css";
import { PlanSketch } from "./plan_sketch";
import { YamlText } from "./yaml_text";

export function MissionDetails() {
  const answer = useSignal<Answer<MissionDetail> | undefined>(undefined);
  const hash = useComputed(() => missions.value?.find((mission) => mission.name === shown.value)?.sha256);
  useSignalEffect(() => {
    void hash.value; // a file that was replaced is read again
    if (!shown.value) return;
    let current = true;
    void ask("get", "/api/missions/{name}", { path: { name: shown.value } }).then((got) => {
      if (current) answer.value = got;
    });
    return () => {
      current = false;
    };
  });
  if (answer.value?.ok === false) {
    return (
      <Panel title="Mission">
        <Empty>It cannot be read: {answer.value.reason}</Empty>
      </Panel>
    );
  }
  const detail = answer.value?.value;
  if (!detail)
    return (
      <Panel title="Mission">
        <Empty>Choose a mission on the left to see its path and file.</Empty>
      </Panel>
    );
  return (
    <div class="column">
      <Panel title={detail.title || detail.name} class="mission-about" aside={<StartHere detail={detail} />}>
        <div class="about">
          <div class="about-text">
            <p>{detail.summary || "No summary."}</p>
            <dl class="facts">
              <div>
                <dt>File</dt>
                <dd class="code">{detail.name}</dd>
              </div>
              <div>
                <dt>Duration</dt>
                <dd class="num">{clock(detail.duration_s)}</dd>
              </div>
              <div>
                <dt>Hash</dt>
                <dd class="code" title={detail.sha256}>
                  {detail.sha256?.slice(0, 12) ?? "–"}
                </dd>
              </div>
              {detail.target && (
                <div>
                  <dt>Target NED</dt>
                  <dd class="num">{detail.target.position_ned_m.map((v) => fixed(v, 1)).join(", ")} m</dd>
                </div>
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

/** Why the mission in view can't start now; "" when it can. */
function reasonAgainst(detail: MissionDetail): string {
  if (choosing.value || detail.name !== shown.value) return "Another mission is being opened";
  if (detail.valid === false) return "The file breaks a rule";
  if (link.value.look !== "live") return "No live vehicle";
  if (foreign(detail)) return `It is for ${detail.vehicle}`;
  if (flying.value) return `Vehicle is ${PHASES[phase.value].toLowerCase()}`;
  if (phase.value === MissionPhase.UNSPECIFIED) return "The vehicle has not told its state";
  return seedRefused.value ? "The seed above is no whole number" : "";
}

function StartHere({ detail }: { detail: MissionDetail }) {
  const why = reasonAgainst(detail);
  return (
    <>
      {why && <span class="muted">{why}</span>}
      <ActButton
        class="action primary"
        why={why || waits.value || barred.value}
        onAct={() => void (choosing.peek() || startShown(detail))}
      >
        <PlayIcon /> Start this mission
      </ActButton>
    </>
  );
}

function Delete({ name }: { name: string }) {
  return (
    <DeleteButton
      name={`Delete ${name}`}
      holdMs={700}
      remove={() => ask("delete", "/api/missions/{name}", { path: { name } })}
      after={async (gone) => {
        if (!gone) return;
        chosen.value = "";
        go("missions", "", {}, true);
        await missions.refresh();
      }}
    />
  );
}
