// One word's meaning beside where it stands. Escape, a press elsewhere or leaving it closes it.
import { useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { asked, sheet } from "./asked";
import { WORDS, type Word } from "./words";

const GAP = 6;

function place(card: HTMLElement, anchor: HTMLElement): void {
  const [at, box] = [anchor.getBoundingClientRect(), card.getBoundingClientRect()];
  const below = at.bottom + GAP + box.height < innerHeight;
  const left = Math.max(GAP, Math.min(at.left, innerWidth - box.width - GAP));
  card.style.left = `${left}px`;
  card.style.top = `${Math.max(GAP, below ? at.bottom + GAP : at.top - GAP - box.height)}px`;
}

export function WordCard() {
  const card = useRef<HTMLDivElement>(null);
  const shown = asked.value;
  useSignalEffect(() => {
    const now = asked.value;
    if (!now || !card.current) return;
    queueMicrotask(() => {
      if (!card.current?.isConnected) return;
      if (!card.current.matches(":popover-open")) card.current.showPopover();
      place(card.current, now.at);
      card.current.focus();
    });
  });
  const word: Word | undefined = shown && WORDS[shown.word];
  return (
    <div
      ref={card}
      popover="auto"
      class="word-card"
      role="dialog"
      aria-label={word ? `${word.symbol}: ${word.name}` : "Word"}
      tabIndex={-1}
      onToggle={(event) => {
        // the browser tells late: by now another word may be shown
        if (event.newState !== "closed" || card.current?.matches(":popover-open")) return;
        const back = asked.peek()?.at;
        asked.value = undefined;
        const focused = document.activeElement;
        if (back?.isConnected && (focused === document.body || focused === card.current)) back.focus();
      }}
    >
      {word && <Meaning word={word} />}
      <p class="hint">
        <button
          type="button"
          class="link"
          onClick={() => {
            card.current?.hidePopover();
            sheet.value = "glossary";
          }}
        >
          All words
        </button>{" "}
        <kbd>?</kbd>
      </p>
    </div>
  );
}

export function Meaning({ word }: { word: Word }) {
  return (
    <>
      <p class="word-head">
        <b>{word.symbol}</b> {word.name !== word.symbol && <span>{word.name}</span>}
        {word.unit && <span class="unit">{word.unit}</span>}
      </p>
      <p>{word.meaning}</p>
      {word.formula && <p class="code">{word.formula}</p>}
    </>
  );
}
