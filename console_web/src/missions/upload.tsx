// Upload by drop or choice. A bad file is refused with a table of what is wrong and where.
import { signal } from "../lib/signal";
import { request, type Refusal } from "../api/http";
import { missions } from "../api/resources";
import { useRef, useState } from "preact/hooks";
import { CheckIcon, UploadIcon } from "../ui/icons";
import { ProblemTable, RefusalNotice } from "../ui/refusal";
import type { MissionSummary } from "../api/types";
import { choose } from "./commands";

interface Upload {
  name: string;
  file: Blob; // its bytes travel as they are
  refusal?: Refusal;
}

const MAX_BYTES = 1_000_000;
const CONFLICT = 409;
const last = signal<Upload | undefined>(undefined);

async function send(name: string, file: Blob, replace: boolean): Promise<void> {
  const query = `name=${encodeURIComponent(name)}${replace ? "&replace=1" : ""}`;
  const answer = await request<MissionSummary>("POST", `api/missions?${query}`, file);
  last.set(answer.ok ? { name, file } : { name, file, refusal: answer });
  if (!answer.ok) return;
  await missions.refresh();
  choose(answer.value.name);
}

async function take(file: File | undefined): Promise<void> {
  if (!file) return;
  if (file.size > MAX_BYTES) {
    const refusal: Refusal = { ok: false, status: 0, reason: "The file is larger than 1 MB: not a mission.", problems: [] };
    last.set({ name: file.name, file, refusal });
    return;
  }
  await send(file.name, file, false);
}

export function UploadZone() {
  const [over, setOver] = useState(false);
  const input = useRef<HTMLInputElement>(null);
  const upload = last.use();
  const drop = (event: DragEvent): void => {
    event.preventDefault();
    setOver(false);
    void take(event.dataTransfer?.files[0]);
  };
  return (
    <section class="panel upload" aria-label="Upload a mission">
      <div
        class="dropzone"
        data-over={over ? "yes" : undefined}
        onDragOver={(event) => {
          event.preventDefault();
          setOver(true);
        }}
        onDragLeave={() => setOver(false)}
        onDrop={drop}
      >
        <UploadIcon size={20} />
        <span>Drop a mission file (YAML) here, or</span>
        <button type="button" class="action" onClick={() => input.current?.click()}>Choose a file</button>
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
        <p class="note good" role="status"><CheckIcon /> {upload.name} is checked and stored.</p>
      )}
      {upload?.refusal && <Refused upload={upload} refusal={upload.refusal} />}
    </section>
  );
}

function Refused({ upload, refusal }: { upload: Upload; refusal: Refusal }) {
  const exists = refusal.status === CONFLICT && refusal.problems.length === 0;
  return (
    <div class="upload-result">
      <RefusalNotice title={`${upload.name} not stored.`} refusal={refusal} onClose={() => last.set(undefined)} />
      {refusal.problems.length > 0 && <ProblemTable problems={refusal.problems} />}
      {exists && (
        <button type="button" class="action" onClick={() => void send(upload.name, upload.file, true)}>
          Replace the stored file
        </button>
      )}
    </div>
  );
}
