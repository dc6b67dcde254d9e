// What the palette finds: views, arrangements, missions, runs, signals, words, parameters, commands.
import { missions, parameterRanges, runs } from "../api/resources";
import { VIEWS } from "../gen/house";
import { setTheme, theme } from "../lib/theme";
import { setZone, zone } from "../lib/zone";
import { ARRANGEMENTS, arrange } from "../live/arrangement";
import { showSignal, signals } from "../live/signals";
import { go } from "../shell/address";
import { chosen } from "../shell/commands";
import { open, sheet } from "./asked";
import { WORDS, type Word, type WordId } from "./words";

export interface Find {
  kind: string;
  name: string;
  about: string;
  act: () => void;
}

function commands(): Find[] {
  const nextTheme = theme.value === "dark" ? "light" : "dark";
  const nextZone = zone.value === "UTC" ? "local" : "UTC";
  return [
    { kind: "Do", name: `Switch to the ${nextTheme} theme`, about: "", act: () => setTheme(nextTheme) },
    {
      kind: "Do",
      name: nextZone === "UTC" ? "Show times in UTC" : "Show local times",
      about: "",
      act: () => setZone(nextZone),
    },
    {
      kind: "Do",
      name: "Words and keys",
      about: "glossary, shortcuts",
      act: () => {
        sheet.value = "glossary";
      },
    },
  ];
}

function parameters(): Find[] {
  return (parameterRanges.value?.ranges ?? []).map(({ path }) => ({
    kind: "Parameter",
    name: path,
    about: "in Mode weights",
    act: () => {
      go("weights");
      const seek = (left: number): void => {
        const field = document.querySelector<HTMLElement>(`[data-path^="${CSS.escape(path)}"]`);
        if (field) field.focus();
        else if (left > 0) requestAnimationFrame(() => seek(left - 1));
      };
      seek(120);
    },
  }));
}

function words(): Find[] {
  return (Object.entries(WORDS) as [WordId, Word][]).map(([id, { symbol, name }]) => ({
    kind: "Word",
    name: symbol === name ? name : `${symbol}: ${name}`,
    about: "",
    act: () =>
      open({ word: id, at: document.querySelector<HTMLElement>("main:not([hidden])") ?? document.body }),
  }));
}

/** All there is, in the order in which equals are shown. */
export function everything(): Find[] {
  return [
    ...VIEWS.map(({ id, name, about }) => ({ kind: "View", name, about, act: () => go(id) })),
    ...ARRANGEMENTS.map(({ value, name, about }) => ({
      kind: "View",
      name: `Live: ${name}`,
      about,
      act: () => arrange(value),
    })),
    ...commands(),
    ...(missions.value ?? []).map(({ name, title, summary }) => ({
      kind: "Mission",
      name: title || name,
      about: `${name} ${summary ?? ""}`,
      act: () => {
        chosen.value = name;
        go("missions", name);
      },
    })),
    ...(runs.value ?? [])
      .filter(({ piece }) => piece <= 1)
      .map(({ id, title }) => ({ kind: "Run", name: id, about: title, act: () => go("runs", id) })),
    ...signals().map(({ id, title, unit }) => ({
      kind: "Signal",
      name: title,
      about: `plot it${unit ? `, ${unit}` : ""}`,
      act: () => {
        arrange("engineer");
        showSignal(id);
      },
    })),
    ...words(),
    ...parameters(),
  ];
}

/** Those that hold every word typed, names that begin with it first. */
export function matching(all: readonly Find[], typed: string): Find[] {
  const parts = typed.toLowerCase().split(/\s+/).filter(Boolean);
  const rank = ({ name }: Find): number => {
    const low = name.toLowerCase();
    return parts.length && low.startsWith(parts[0] as string) ? 0 : low.includes(parts[0] ?? "") ? 1 : 2;
  };
  return all
    .filter(({ kind, name, about }) => {
      const text = `${kind} ${name} ${about}`.toLowerCase();
      return parts.every((part) => text.includes(part));
    })
    .map((find, index) => ({ find, index }))
    .sort((a, b) => rank(a.find) - rank(b.find) || a.index - b.index)
    .map(({ find }) => find);
}
