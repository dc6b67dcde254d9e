// What the library lists: drafts only here first, then stored missions, then those that come with Bumpless.
import { missions } from "../../api/resources";
import { ownFirst } from "../../stream/present";
import { draftNames } from "../model/library";

export interface Entry {
  name: string;
  title: string;
  about: string;
  vehicle: string;
  duration: number | null;
  builtin: boolean;
  draft: boolean;
  valid: boolean;
  tags: readonly string[];
  archived: boolean;
  /** On the server, not only in this browser. */
  stored: boolean;
}

export function entries(): Entry[] {
  const files = missions.value ?? [];
  const drafts = new Set(draftNames.value);
  const stored = files.map((file) => ({
    name: file.name,
    title: file.title || file.name,
    about: file.summary,
    vehicle: file.vehicle,
    duration: file.duration_s,
    builtin: file.builtin === true,
    draft: drafts.has(file.name),
    valid: file.valid !== false,
    tags: file.tags ?? [],
    archived: file.archived === true,
    stored: true,
  }));
  const known = new Set(files.map((file) => file.name));
  const only = [...drafts]
    .filter((one) => !known.has(one))
    .map((one) => ({
      name: one,
      title: one,
      about: "Only in this browser",
      vehicle: "",
      duration: null,
      builtin: false,
      draft: true,
      valid: true,
      tags: [],
      archived: false,
      stored: false,
    }));
  return ownFirst([...only, ...stored.filter((one) => !one.builtin), ...stored.filter((one) => one.builtin)]);
}
