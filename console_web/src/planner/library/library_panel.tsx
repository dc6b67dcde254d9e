// All missions: stored ones, those that come with Bumpless, and drafts of this browser. Opened from the plan's top line.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { ask } from "../../api/client";
import { Resource } from "../../api/resource";
import { missions } from "../../api/resources";
import { present } from "../../stream/present";
import { CrossIcon } from "../../ui/icons";
import { tool } from "../map/tools";
import { fromText, importFile, name, newMission } from "../model/library";
import { type Entry, entries } from "./entries";
import { Row } from "./library_row";
import "./library_panel.css";

function told({ name, title, about, tags, vehicle }: Entry): string {
  return [name, title, about, vehicle, ...tags].join(" ").toLowerCase();
}

export function begin(): void {
  newMission(present.peek() || "ts100");
  tool.value = "waypoint";
}

export function Library({ onClose }: { onClose: () => void }) {
  const wanted = useSignal("");
  const tag = useSignal("");
  const put = useSignal(false); // those that were put away
  const box = useRef<HTMLInputElement>(null);
  useEffect(() => {
    void missions.refresh();
    box.current?.focus();
  }, []);
  const all = entries();
  const away = all.filter(({ archived }) => archived).length;
  const tags = [
    ...new Set(all.filter(({ archived }) => archived === put.value).flatMap((one) => one.tags)),
  ].sort();
  const words = wanted.value.toLowerCase().split(/\s+/).filter(Boolean);
  const shown = all.filter(
    (entry) =>
      entry.archived === put.value &&
      (tag.value === "" || entry.tags.includes(tag.value)) &&
      words.every((word) => told(entry).includes(word)),
  );
  return (
    <section class="panel library" aria-label="Missions to open">
      <header class="panel-head">
        <h2>Open a mission</h2>
        <span class="grow" />
        <button
          type="button"
          class="action small primary"
          onClick={() => {
            begin();
            onClose();
          }}
        >
          New mission
        </button>
        <Import onClose={onClose} />
        {name.value && (
          <button type="button" class="quiet" aria-label="Close the list" onClick={onClose}>
            <CrossIcon />
          </button>
        )}
      </header>
      <div class="library-search">
        <input
          ref={box}
          type="search"
          aria-label="Search missions"
          placeholder="Search by name, title or purpose"
          value={wanted.value}
          onInput={(event) => {
            wanted.value = event.currentTarget.value;
          }}
          onKeyDown={(event) => event.key === "Escape" && onClose()}
        />
      </div>
      {words.length === 0 && !put.value && <Templates onClose={onClose} />}
      {(tags.length > 0 || away > 0) && (
        <div class="library-tags" role="group" aria-label="Which missions">
          {tags.map((word) => (
            <button
              key={word}
              type="button"
              class="action small"
              aria-pressed={tag.value === word}
              onClick={() => {
                tag.value = tag.peek() === word ? "" : word;
              }}
            >
              {word}
            </button>
          ))}
          <span class="grow" />
          {(away > 0 || put.value) && (
            <button
              type="button"
              class="action small"
              aria-pressed={put.value}
              onClick={() => {
                tag.value = "";
                put.value = !put.peek();
              }}
            >
              Archive ({away})
            </button>
          )}
        </div>
      )}
      <ul class="library-rows">
        {shown.map((entry) => (
          <Row key={entry.name} entry={entry} onClose={onClose} />
        ))}
        {shown.length === 0 && (
          <li class="empty">
            {words.length || tag.value
              ? "No mission has these words."
              : put.value
                ? "Nothing is put away."
                : "No missions yet: begin a new one."}
          </li>
        )}
      </ul>
    </section>
  );
}

const templates = new Resource(() => ask("get", "/api/mission-templates"));

function Templates({ onClose }: { onClose: () => void }) {
  const list = templates.value ?? [];
  if (list.length === 0) return null;
  return (
    <div class="library-templates">
      <span class="muted">Begin from</span>
      {list.map(({ name: id, title, summary, yaml }) => (
        <button
          key={id}
          type="button"
          class="action small"
          title={summary}
          onClick={() => {
            fromText(id, yaml);
            onClose();
          }}
        >
          {title}
        </button>
      ))}
    </div>
  );
}

const FOREIGN = ".yaml,.yml,.plan,.waypoints,.txt,.geojson,.json,.kml,.kmz,.csv,.bhv,.nmis,.nmisz";

function Import({ onClose }: { onClose: () => void }) {
  const box = useRef<HTMLInputElement>(null);
  return (
    <>
      <button
        type="button"
        class="action small"
        title="YAML, QGroundControl .plan, WPL, GeoJSON, KML, CSV, MOOS-IvP .bhv, Neptus .nmis"
        onClick={() => box.current?.click()}
      >
        Import …
      </button>
      <input
        ref={box}
        type="file"
        accept={FOREIGN}
        class="sr"
        tabIndex={-1}
        aria-label="File to import"
        onChange={(event) => {
          const [file] = event.currentTarget.files ?? [];
          event.currentTarget.value = "";
          if (file) void importFile(file).then(onClose);
        }}
      />
    </>
  );
}
