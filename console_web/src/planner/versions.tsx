// Earlier versions of the open mission: when each was saved, how it differs from what is shown, and the way back to it.
import { signal, useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { ask } from "../api/client";
import type { components } from "../gen/api";
import { bytes, dateTime } from "../lib/format";
import { ActButton } from "../ui/act_button";
import { CrossIcon } from "../ui/icons";
import { Empty } from "../ui/panel";
import { name } from "./model/library";
import { around, lineDiff } from "./model/line_diff";
import { setText, text } from "./model/plan";
import "./preflight.css";
import "./versions.css";

type Version = components["schemas"]["VersionAnswer"];
export const versionsOpen = signal(false);
const CONTEXT = 2;

export function Versions() {
  const sheet = useRef<HTMLDialogElement>(null);
  const open = versionsOpen.value;
  useEffect(() => {
    const dialog = sheet.current;
    if (open && dialog && !dialog.open) dialog.showModal();
    if (!open && dialog?.open) dialog.close();
  }, [open]);
  const close = (): void => {
    versionsOpen.value = false;
  };
  return (
    <dialog ref={sheet} class="preflight versions" aria-label="Earlier versions" onClose={close}>
      {open && (
        <>
          <header class="panel-head">
            <h2>Earlier versions of {name.value}</h2>
            <span class="grow" />
            <button type="button" class="quiet" aria-label="Close" onClick={close}>
              <CrossIcon />
            </button>
          </header>
          <List onTaken={close} />
        </>
      )}
    </dialog>
  );
}

function List({ onTaken }: { onTaken: () => void }) {
  const list = useSignal<Version[] | undefined>(undefined);
  const chosen = useSignal("");
  useEffect(() => {
    void ask("get", "/api/missions/{name}/history", { path: { name: name.peek() } }).then((answer) => {
      list.value = answer.ok ? answer.value : [];
    });
  }, []);
  if (list.value?.length === 0)
    return <Empty>None is kept: versions begin with the first time it is saved here.</Empty>;
  return (
    <div class="versions-body">
      <ul>
        {list.value?.map(({ id, saved, size }) => (
          <li key={id}>
            <button
              type="button"
              class="worst-row"
              aria-pressed={chosen.value === id}
              onClick={() => {
                chosen.value = id;
              }}
            >
              <span class="num">{dateTime(saved)}</span>
              <span class="muted num">{bytes(size)}</span>
            </button>
          </li>
        ))}
      </ul>
      {chosen.value && <Difference key={chosen.value} id={chosen.value} onTaken={onTaken} />}
    </div>
  );
}

function Difference({ id, onTaken }: { id: string; onTaken: () => void }) {
  const old = useSignal<string | undefined>(undefined);
  useSignalEffect(() => {
    void ask("get", "/api/missions/{name}/history/{version}", {
      path: { name: name.peek(), version: id },
    }).then((answer) => {
      if (answer.ok) old.value = answer.value.yaml;
    });
  });
  const before = old.value;
  if (before === undefined) return null;
  const lines = around(lineDiff(text.value, before), CONTEXT);
  return (
    <div class="versions-difference">
      <p class="muted">
        {lines.length === 0 ? "The same as what is shown." : "From what is shown to this version:"}
      </p>
      <pre class="versions-diff" role="region" tabIndex={0} aria-label="Difference">
        {lines.map((line, i) => (
          <span key={i} data-kind={line?.kind ?? "gap"}>
            {line ? `${{ same: " ", gone: "\u2212", new: "+" }[line.kind]} ${line.text}` : "…"}
            {"\n"}
          </span>
        ))}
      </pre>
      <ActButton
        class="action"
        why={lines.length === 0 ? "It is the same as what is shown" : ""}
        title="Ctrl+Z takes it back"
        onAct={() => {
          setText(before, "Take an earlier version");
          onTaken();
        }}
      >
        Take this version
      </ActButton>
    </div>
  );
}
