// Top line: where you are, which vehicle, whether it is live, whether it is recorded.
import { HELP, VIEWS } from "../gen/house";
import { age, bytes } from "../lib/format";
import { setTheme, theme } from "../lib/theme";
import { setZone, timeOfDay, zone, zoneName } from "../lib/zone";
import { type LinkLook, link } from "../stream/link";
import { draft } from "../weights/draft";
import { sheet } from "../words/asked";
import { href } from "./address";
import { OpenBus } from "./open_bus";
import { view } from "./views";
import "./header.css";
import { AlarmCount } from "../alarms/alarm_count";
import { live } from "../stream/store";
import {
  AlarmIcon,
  CheckIcon,
  FindIcon,
  HollowIcon,
  MoonIcon,
  RecordIcon,
  SunIcon,
  WarningIcon,
} from "../ui/icons";

export function Header() {
  const badge = draft.changedPaths.value.length;
  return (
    <header class="topbar">
      <a class="brand" href={href("live")} aria-label="Bumpless, live view">
        <Logo />
        <span>Bumpless</span>
      </a>
      <nav aria-label="Views">
        {VIEWS.map(({ id, name, about }) => (
          <a
            key={id}
            href={href(id)}
            class="tab"
            title={about}
            aria-current={view.value === id ? "page" : undefined}
          >
            {name}
            {id === "weights" && badge > 0 && (
              <span class="count" title={`${badge} change(s) in the draft`}>
                {badge}
              </span>
            )}
          </a>
        ))}
        <a href={HELP} class="tab" target="_blank" rel="noopener" title="The manual, in a tab of its own">
          Help
        </a>
      </nav>
      <span class="grow" />
      <Vehicle />
      <AlarmCount />
      <OpenBus />
      <Clock />
      <Recording />
      <button
        type="button"
        class="quiet"
        aria-label="Find everything (Ctrl+K)"
        title="Find everything: Ctrl+K"
        aria-haspopup="dialog"
        onClick={() => {
          sheet.value = "palette";
        }}
      >
        <FindIcon size={16} />
      </button>
      <button
        type="button"
        class="quiet"
        aria-label="Words and keys (?)"
        title="Words and keys: ?"
        aria-haspopup="dialog"
        onClick={() => {
          sheet.value = "glossary";
        }}
      >
        <b aria-hidden="true">?</b>
      </button>
      <ThemeButton />
    </header>
  );
}

const LINK_ICONS: Record<LinkLook, typeof CheckIcon> = {
  live: CheckIcon,
  stale: WarningIcon,
  lost: AlarmIcon,
  offline: AlarmIcon,
  waiting: HollowIcon,
};

function Vehicle() {
  const { look, label } = link.value;
  const description = live.latest("tlm/description");
  const health = live.latest("tlm/health");
  const status = live.latest("server/status");
  const Icon = LINK_ICONS[look];
  const seconds = live.age("tlm/navigation");
  const name = description?.vehicleName || status?.vehicleId || "No vehicle";
  const details = [
    description && `${description.vehicleId}, software ${description.softwareVersion}`,
    health && `missed cycles ${health.missedCycles}, lateness p99 ${health.latenessP99Ms.toFixed(1)} ms`,
    status && `node restarts ${status.nodeRestarts}, server ${status.serverVersion}`,
  ].filter(Boolean);
  return (
    <div class="header-item" title={details.join("\n")}>
      <span class="vehicle-name">{name}</span>
      {health && health.missedCycles > 0n && (
        <span class="chip" data-look="stale" title="Control cycles missed since the node started">
          <WarningIcon /> {String(health.missedCycles)} <span class="spare">missed</span>
        </span>
      )}
      <span class="chip link-chip" data-look={look} role="status" aria-label={`Link: ${label}`}>
        <Icon /> {label}
        {look !== "live" && seconds !== undefined && <span class="num spare"> {age(seconds)}</span>}
      </span>
    </div>
  );
}

function Recording() {
  const status = live.latest("server/status");
  if (status && !live.isFresh("server/status")) {
    return (
      <span class="chip unknown" data-look="off" title="Not known: the server does not answer">
        <HollowIcon size={11} />
        <span>
          Rec<span class="spare">ording unknown</span>
        </span>
      </span>
    );
  }
  const on = Boolean(status?.recording);
  const lost = Number(status?.recorderDropped ?? 0n);
  if (!on && status?.recorderTrouble) {
    return (
      <span
        class="chip recording"
        data-look="lost"
        role="status"
        title={`Runs are not being recorded: ${status.recorderTrouble}`}
      >
        <AlarmIcon />
        <span>
          Cannot rec<span class="spare">ord</span>
        </span>
      </span>
    );
  }
  return (
    <span
      class="chip recording"
      data-look={on ? "recording" : "off"}
      data-beat={on ? beat() : undefined}
      title={
        on
          ? `Run ${status?.recordingRunId}, ${bytes(status?.recordedBytes)}`
          : "Each mission is recorded from start to end"
      }
    >
      {on ? <RecordIcon size={11} /> : <HollowIcon size={11} />}
      {on ? (
        <>
          REC <span class="num spare">{bytes(status?.recordedBytes)}</span>
        </>
      ) : (
        <span>
          Not rec<span class="spare">ording</span>
        </span>
      )}
      {lost > 0 && <span class="lost"> {lost} dropped</span>}
    </span>
  );
}

function beat(): "on" | "off" {
  return Math.floor(live.now.value / 1000) % 2 ? "on" : "off";
}

/** The time, always with its zone; a click changes the zone everywhere. */
function Clock() {
  void live.now.value;
  const now = new Date();
  const next = zone.value === "UTC" ? "local" : "UTC";
  return (
    <button
      type="button"
      class="quiet num clock"
      title={`Show ${next === "UTC" ? "UTC" : "local time"} everywhere`}
      onClick={() => setZone(next)}
    >
      {timeOfDay(now).slice(0, 5)}
      <span class="seconds">{timeOfDay(now).slice(5)}</span>
      {`\u00a0${zoneName(now)}`}
    </button>
  );
}

function ThemeButton() {
  const next = theme.value === "dark" ? "light" : "dark";
  return (
    <button
      type="button"
      class="quiet"
      aria-label={`Switch to the ${next} theme`}
      onClick={() => setTheme(next)}
    >
      {next === "light" ? <SunIcon size={16} /> : <MoonIcon size={16} />}
    </button>
  );
}

function Logo() {
  return (
    <svg width="26" height="20" viewBox="0 0 32 24" aria-hidden="true">
      <path
        d="M3 18C11 18 10 7 16 7S23 7 29 7"
        fill="none"
        class="logo-path"
        stroke-width="3"
        stroke-linecap="round"
      />
      <circle cx="16" cy="7" r="3" class="logo-way" />
      <circle cx="29" cy="7" r="3" class="logo-end" />
    </svg>
  );
}
