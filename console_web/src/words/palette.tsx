// One line that finds everything: type, choose by arrows, Enter.
import { useSignal } from "@preact/signals";
import { useLayoutEffect, useMemo, useRef } from "preact/hooks";
import { sheet } from "./asked";
import { Dialog } from "./dialog";
import { everything, type Find, matching } from "./finds";

const SHOWN = 12;

export function Palette() {
  const typed = useSignal("");
  const at = useSignal(0);
  const list = useRef<HTMLDivElement>(null);
  const all = everything();
  const found = useMemo(() => matching(all, typed.value).slice(0, 60), [typed.value, all.length]);
  const close = (): void => {
    if (sheet.peek() === "palette") sheet.value = undefined;
  };
  const take = (find: Find | undefined): void => {
    if (!find) return;
    close();
    queueMicrotask(() => requestAnimationFrame(find.act)); // when the sheet has given the focus back
  };
  useLayoutEffect(() => {
    list.current?.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: "nearest" });
  });
  const move = (event: KeyboardEvent): void => {
    const by = { ArrowDown: 1, ArrowUp: -1, PageDown: SHOWN, PageUp: -SHOWN }[event.key];
    if (by !== undefined) at.value = Math.max(0, Math.min(found.length - 1, at.value + by));
    else if (event.key === "Enter") take(found[at.value]);
    else return;
    event.preventDefault();
  };
  const chosen = found[at.value];
  return (
    <Dialog name="Find everything" class="palette" onClose={close}>
      <input
        type="text"
        role="combobox"
        aria-label="Find views, missions, runs, signals, words, parameters, commands"
        aria-expanded="true"
        aria-controls="palette-list"
        aria-activedescendant={chosen ? `palette-${at.value}` : undefined}
        placeholder="Find views, missions, runs, signals, words, commands"
        value={typed.value}
        onInput={(event) => {
          typed.value = event.currentTarget.value;
          at.value = 0;
        }}
        onKeyDown={move}
      />
      <div ref={list} id="palette-list" class="found" role="listbox" aria-label="Found" tabIndex={-1}>
        {found.map((find, index) => (
          // biome-ignore lint/a11y/useKeyWithClickEvents: the combobox above takes the keys
          <div
            key={`${find.kind}${find.name}`}
            id={`palette-${index}`}
            role="option"
            aria-selected={index === at.value}
            tabIndex={-1}
            onClick={() => take(find)}
          >
            <span class="tag">{find.kind}</span> <b>{find.name}</b>{" "}
            <span class="muted ellipsis">{find.about}</span>
          </div>
        ))}
      </div>
      {!found.length && (
        <p class="empty" role="status">
          Nothing of that name.
        </p>
      )}
    </Dialog>
  );
}
