// What runs take of the disk, and what is left of it.
import { runsDisk } from "../api/resources";
import { bytes } from "../lib/format";

export function DiskUse() {
  const use = runsDisk.value;
  if (!use) return null;
  const most = use.max_bytes ? ` of ${bytes(use.max_bytes)}` : "";
  const bin = use.bin ? `, ${bytes(use.bin_bytes)} in the bin` : "";
  return (
    <p class="disk-use muted num">
      {use.runs} {use.runs === 1 ? "file takes" : "files take"} {bytes(use.runs_bytes)}
      {most}
      {bin}; {bytes(use.free_bytes)} free
    </p>
  );
}
