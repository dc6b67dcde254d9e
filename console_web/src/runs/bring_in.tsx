// Logs from elsewhere: dropped on the list or chosen; each comes into the list, or says why not.
import { signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { address } from "../api/client";
import { request } from "../api/http";
import { runs } from "../api/resources";
import type { RunSummary } from "../api/types";
import { go } from "../shell/address";
import { RefusalNotice } from "../ui/refusal";

const PATIENCE_MS = 600_000;

interface Told {
  name: string;
  reason: string;
}

const coming = signal(0);
const refusals = signal<readonly Told[]>([]);
const over = signal(false);

async function bringIn(files: Iterable<File>): Promise<void> {
  refusals.value = [];
  for (const file of files) {
    coming.value++;
    const to = address("/api/runs-import", {}, { name: file.name });
    const answer = await request<RunSummary>("POST", to, file, { timeoutMs: PATIENCE_MS });
    coming.value--;
    if (!answer.ok) refusals.value = [...refusals.value, { name: file.name, reason: answer.reason }];
    else {
      await runs.refresh();
      go("runs", answer.value.id);
    }
  }
}

/** Takes what is dropped on its content. */
export function DropArea({ children }: { children: ComponentChildren }) {
  return (
    <div
      role="group"
      aria-label="Runs, and logs that are dropped here"
      class="drop-area"
      data-over={over.value ? "yes" : undefined}
      onDragOver={(event) => {
        if (!event.dataTransfer?.types.includes("Files")) return;
        event.preventDefault();
        over.value = true;
      }}
      onDragLeave={() => {
        over.value = false;
      }}
      onDrop={(event) => {
        over.value = false;
        const files = [...(event.dataTransfer?.files ?? [])];
        if (!files.length) return;
        event.preventDefault();
        void bringIn(files);
      }}
    >
      {refusals.value.map(({ name, reason }) => (
        <RefusalNotice
          key={name}
          title={`${name} not taken in.`}
          refusal={{ ok: false, status: 422, reason, problems: [] }}
          onClose={() => {
            refusals.value = refusals.value.filter((told) => told.name !== name);
          }}
        />
      ))}
      {over.value && <p class="drop-here">Drop logs here to take them into the list</p>}
      {children}
    </div>
  );
}

export function BringIn() {
  return (
    <label
      class="action small bring-in"
      title="MCAP files with our messages, other recorders' too; or drop them"
    >
      {coming.value ? `Taking in ${coming.value}` : "Import"}
      <input
        type="file"
        class="sr"
        accept=".mcap"
        multiple
        aria-label="Import logs"
        onChange={(event) => {
          const files = [...(event.currentTarget.files ?? [])];
          event.currentTarget.value = "";
          void bringIn(files);
        }}
      />
    </label>
  );
}
