// Every word, every key, and every number that can be tuned, searched as one types.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { ask } from "../api/client";
import { asked, sheet } from "./asked";
import { Dialog } from "./dialog";
import { type Keys, plannerKeys, SHORTCUTS } from "./shortcuts";
import { Meaning } from "./word_card";
import { WORDS, type Word } from "./words";

/** Parameters as their one declaration tells them. */
async function tuned(): Promise<Word[]> {
  const answer = await ask("get", "/api/fields/{kind}", { path: { kind: "parameters" } });
  if (!answer.ok) return [];
  return answer.value.map(({ path, label, help, unit }) => ({
    symbol: label || path,
    name: path,
    unit,
    meaning: help,
  }));
}

function fits(text: string, wanted: string): boolean {
  return text.toLowerCase().includes(wanted.trim().toLowerCase());
}

export function Glossary() {
  const wanted = useSignal("");
  const parameters = useSignal<Word[]>([]);
  const planner = useSignal<Keys[]>([]);
  useEffect(() => {
    asked.value = undefined;
    void plannerKeys().then(
      (keys) => {
        planner.value = [keys];
      },
      () => {}, // the server is away: the keys of what is loaded are here
    );
    void tuned().then((words) => {
      parameters.value = words;
    });
  }, []);
  const close = (): void => {
    sheet.value = undefined;
  };
  const found = (words: readonly Word[]): Word[] =>
    words.filter(({ symbol, name, meaning }) => fits(`${symbol} ${name} ${meaning}`, wanted.value));
  const groups: [string, Word[]][] = [
    ["Words and symbols", found(Object.values(WORDS))],
    ["What can be tuned", found(parameters.value)],
  ];
  const keys = [...SHORTCUTS, ...planner.value]
    .map((group) => ({
      ...group,
      keys: group.keys.filter(([key, what]) => fits(`${key} ${what}`, wanted.value)),
    }))
    .filter((group) => group.keys.length);
  return (
    <Dialog name="Words and keys" class="glossary" onClose={close}>
      <div class="sheet-head">
        <input
          type="search"
          aria-label="Search words and keys"
          placeholder="Search words and keys"
          value={wanted.value}
          onInput={(event) => {
            wanted.value = event.currentTarget.value;
          }}
        />
        <button type="button" class="action small" onClick={close}>
          Close
        </button>
      </div>
      <div class="sheet-body" tabIndex={0}>
        {keys.map((group) => (
          <section key={group.name} aria-label={group.name}>
            <h2>{group.name}</h2>
            <dl class="keys">
              {group.keys.map(([key, what]) => (
                <div key={key}>
                  <dt>
                    <kbd>{key}</kbd>
                  </dt>
                  <dd>{what}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
        {groups.map(
          ([name, words]) =>
            words.length > 0 && (
              <section key={name} aria-label={name}>
                <h2>{name}</h2>
                {words.map((word) => (
                  <article key={word.symbol + word.name}>
                    <Meaning word={word} />
                  </article>
                ))}
              </section>
            ),
        )}
        {!keys.length && groups.every(([, words]) => !words.length) && (
          <p class="empty">Nothing of that name.</p>
        )}
      </div>
    </Dialog>
  );
}
