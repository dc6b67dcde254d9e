// Whether the sheet before the start is open.
import { signal } from "@preact/signals";

export const preflight = signal(false);
