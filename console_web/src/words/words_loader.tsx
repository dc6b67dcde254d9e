// Loads what the words need when the first is asked for: nothing of it is in the first load.
import { signal, useSignalEffect } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { asked, onKey, sheet } from "./asked";

const sheets = signal<ComponentType | undefined>(undefined);

async function load(): Promise<void> {
  try {
    sheets.value ??= (await import("./sheets")).Sheets;
  } catch {
    asked.value = sheet.value = undefined; // the server is away
  }
}

export function Words() {
  useEffect(() => {
    addEventListener("keydown", onKey);
    return () => removeEventListener("keydown", onKey);
  }, []);
  useSignalEffect(() => {
    if (asked.value || sheet.value) void load();
  });
  const Sheets = sheets.value;
  return Sheets ? <Sheets /> : null;
}
