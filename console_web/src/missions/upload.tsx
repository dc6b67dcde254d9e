// Upload by drop or choice. A bad file is refused with a table of what is wrong and where.
import { signal, useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { ask } from "../api/client";
import type { Refusal } from "../api/http";
import { missions } from "../api/resources";
import { choosing, chosen } from "../shell/commands";
import { CheckIcon, UploadIcon } from "../ui/icons";
import { ProblemTable, RefusalNotice } from "../ui/refusal";
import "./upload.css";

interface Upload {
  name: string;
  file: Blob; // its bytes travel as they are
  refusal?: Refusal;
}

const MAX_BYTES = 1_000_000;
const CONFLICT = 409;
const last = signal<Upload | undefined>(undefined);

async function send(name: string, file: Blob, replace: boolean): Promise<void> {
  const query = replace ? { name, replace } : { name };
  choosing.value = true;
  try {
    const answer = await ask("post", "/api/missions", { query, body: file });
    last.value = answer.ok ? { name, file } : { name, file, refusal: answer };
    if (!answer.ok) return;
    await missions.refresh();
    chosen.value = answer.value.name;
  } finally {
    choosing.value = false;
  }
}

async function take(file: File | undefined): Promise<void> {
  if (!file) return;
  if (file.size > MAX_BYTES) {
    const refusal: Refusal = {
      ok: false,
      status: 0,
      reason: "The file is larger than 1 MB: not a mission.",
      problems: [],
    };
    last.value = { name: file.name, file, refusal };
    return;
  }
  await send(file.name, file, false);
}

export function UploadZone() {
  const over = useSignal(false);
  const input = useRef<HTMLInputElement>(null);
  const upload = last.value;
  const drop = (event: DragEvent): void => {
    event.preventDefault();
    over.value = false;
    void take(event.dataTransfer?.files[0]);
  };
  return (
    <section class="panel upload" aria-label="Upload a mission">
      {/* biome-ignore lint/a11y/noStaticElementInteractions: the button inside does the same by keyboard */}
      <div
        class="dropzone"
        data-over={over.value ? "yes" : undefined}
        onDragOver={(event) => {
          event.preventDefault();
          over.value = true;
        }}
        onDragLeave={() => {
          over.value = false;
        }}
        onDrop={drop}
      >
        <UploadIcon size={20} />
        <span>Drop a mission file (YAML) here, or</span>
        <button type="button" class="action" onClick={() => input.current?.click()}>
          Choose a file
        </button>
        <input
          ref={input}
          type="file"
          accept=".yaml,.yml,text/yaml"
          class="sr"
          tabIndex={-1}
          aria-label="Mission file"
          onChange={(event) => {
            const field = event.currentTarget;
            void take(field.files?.[0]).then(() => {
              field.value = "";
            });
          }}
        />
      </div>
      {upload && !upload.refusal && (
        <p class="note good" role="status">
          <CheckIcon /> {upload.name} is checked and stored.
        </p>
      )}
      {upload?.refusal && <Refused upload={upload} refusal={upload.refusal} />}
    </section>
  );
}

function Refused({ upload, refusal }: { upload: Upload; refusal: Refusal }) {
  const exists = refusal.status === CONFLICT && refusal.problems.length === 0;
  return (
    <div class="upload-result">
      <RefusalNotice
        title={`${upload.name} not stored.`}
        refusal={refusal}
        onClose={() => {
          last.value = undefined;
        }}
      />
      {refusal.problems.length > 0 && <ProblemTable problems={refusal.problems} />}
      {exists && (
        <button type="button" class="action" onClick={() => void send(upload.name, upload.file, true)}>
          Replace the stored file
        </button>
      )}
    </div>
  );
}
