// Every command and change of rights, newest first; the whole file as a download.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { address } from "../api/client";
import type { AuditEntry } from "../api/types";
import { dateTime, fixed } from "../lib/format";
import { DownloadIcon } from "../ui/icons";
import { Empty } from "../ui/panel";
import { changesOf, found } from "./audited";
import { audit } from "./resources";

const LOOKS = { accepted: "good", refused: "lost", none: "lost" } as const;
const ANSWERS = { accepted: "accepted", refused: "refused", none: "no answer" } as const;

export function AuditTable() {
  useEffect(() => void audit.refresh(), []);
  const words = useSignal("");
  const { value: entries, refusal } = audit;
  const shown = found(entries ?? [], words.value);
  return (
    <>
      <div class="system-tools">
        <input
          type="search"
          aria-label="Search in the audit"
          placeholder="Search"
          value={words.value}
          onInput={(event) => {
            words.value = event.currentTarget.value;
          }}
        />
        <button type="button" class="action small" onClick={() => void audit.refresh()}>
          Refresh
        </button>
        <span class="grow" />
        <a class="action small" href={address("/api/audit.jsonl")} download="audit.jsonl">
          <DownloadIcon size={12} /> All as a file
        </a>
      </div>
      {refusal && <Empty>The audit cannot be read: {refusal.reason}</Empty>}
      {entries?.length === 0 && <Empty>No command was given yet.</Empty>}
      {shown.length > 0 && (
        <table class="table compact">
          <thead>
            <tr>
              <th scope="col">Time</th>
              <th scope="col">Who</th>
              <th scope="col">Asked for</th>
              <th scope="col">Changed</th>
              <th scope="col">Answer</th>
              <th scope="col" class="num">
                Took
              </th>
            </tr>
          </thead>
          <tbody>
            {shown.map((entry) => (
              <Row key={`${entry.id}${entry.time}`} entry={entry} />
            ))}
          </tbody>
        </table>
      )}
    </>
  );
}

function Row({ entry }: { entry: AuditEntry }) {
  return (
    <tr>
      <td class="when">{dateTime(entry.time)}</td>
      <td title={entry.address}>{entry.author || <span class="muted">{entry.address || "–"}</span>}</td>
      <th scope="row">{entry.verb.replaceAll("_", " ")}</th>
      <td class="wraps code">{changesOf(entry).join("; ")}</td>
      <td class="wraps">
        <span class={LOOKS[entry.answer]}>{ANSWERS[entry.answer]}</span>{" "}
        <span class="muted">{entry.said}</span>
      </td>
      <td class="num">{entry.took_s > 0 && `${fixed(entry.took_s, 2)} s`}</td>
    </tr>
  );
}
