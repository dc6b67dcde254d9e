// A line of the text that a finding points to; the text editor goes there.
import { signal } from "@preact/signals";

export const jump = signal<number | undefined>(undefined);
