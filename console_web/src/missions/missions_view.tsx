// Missions: the list, a place to drop a file, and the chosen mission in full.
import { useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { missions } from "../api/resources";
import type { MissionSummary } from "../api/types";
import { clock } from "../lib/format";
import { address, go } from "../shell/address";
import { chosen, mission as shown } from "../shell/commands";
import { flying as flyingNow } from "../stream/link";
import { live } from "../stream/store";
import { RecordIcon, WarningIcon } from "../ui/icons";
import { Main } from "../ui/main";
import { Empty, Panel } from "../ui/panel";
import "./missions_view.css";
import { MissionDetails } from "./mission_details";
import { UploadZone } from "./upload";

export function MissionsView() {
  useEffect(() => void missions.refresh(), []);
  useSignalEffect(() => {
    const { view, id } = address.value;
    if (view === "missions" && id) chosen.value = id;
  });
  return (
    <Main name="Missions" class="view missions">
      <div class="column">
        <UploadZone />
        <MissionList />
      </div>
      <MissionDetails />
    </Main>
  );
}

function MissionList() {
  const { value: list, refusal } = missions;
  const { view, id } = address.value;
  const gone = view === "missions" && list && !list.some(({ name }) => name === id) ? id : "";
  const flying = flyingNow.value ? live.latest("tlm/mission")?.missionSha256 : undefined;
  return (
    <Panel title="Missions" class="mission-list" aside={<span class="muted num">{list?.length ?? ""}</span>}>
      {refusal && <Empty>The list cannot be read: {refusal.reason}</Empty>}
      {gone && (
        <Empty>
          There is no mission {gone} here. {shown.value && `${shown.value} is shown.`}
        </Empty>
      )}
      {list?.length === 0 && <Empty>No missions yet. Drop a mission file above, or choose one.</Empty>}
      <ul class="rows">
        {list?.map((mission) => (
          <MissionRow
            key={mission.name}
            mission={mission}
            flying={mission.sha256 !== undefined && mission.sha256 === flying}
          />
        ))}
      </ul>
    </Panel>
  );
}

function MissionRow({ mission, flying }: { mission: MissionSummary; flying: boolean }) {
  return (
    <li>
      <button
        type="button"
        class="row"
        aria-pressed={shown.value === mission.name}
        onClick={() => {
          chosen.value = mission.name;
          go("missions", mission.name, {}, true);
        }}
      >
        <span class="row-title">
          <b>{mission.title || mission.name}</b>
          {flying && (
            <span class="chip" data-look="running">
              <RecordIcon size={9} /> flying
            </span>
          )}
          {mission.valid === false && (
            <span class="chip" data-look="stale">
              <WarningIcon size={11} /> not valid
            </span>
          )}
          {mission.builtin === false && <span class="tag">uploaded</span>}
        </span>
        <span class="row-text muted">
          <span class="code">{mission.name}</span>
          {mission.duration_s != null && <span class="num">{clock(mission.duration_s)}</span>}
        </span>
      </button>
    </li>
  );
}
