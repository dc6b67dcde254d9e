// CodeMirror as the planner wants it: YAML, margin, completion, and no history of its own.
import { autocompletion, closeBrackets, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, indentWithTab } from "@codemirror/commands";
import { yaml } from "@codemirror/lang-yaml";
import { HighlightStyle, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { lintGutter, lintKeymap } from "@codemirror/lint";
import { EditorState, Transaction } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { redo, undo } from "../model/plan";
import { complete } from "./completion";

const LOOK = EditorView.theme({
  "&": { height: "100%", fontSize: "var(--text-sm)", backgroundColor: "transparent", color: "var(--ink)" },
  "&.cm-focused": { outline: "var(--rule) solid var(--accent)", outlineOffset: "calc(-1 * var(--rule))" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.5" },
  ".cm-content": { caretColor: "var(--ink)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": {
    backgroundColor: "var(--panel)",
    color: "var(--ink-2)",
    borderRight: "1px solid var(--line)",
  },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--raised) 60%, transparent)" },
  ".cm-selectionBackground, &.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground": {
    backgroundColor: "var(--accent-soft)",
  },
  ".cm-tooltip": {
    backgroundColor: "var(--raised)",
    color: "var(--ink)",
    border: "1px solid var(--line-2)",
    borderRadius: "var(--radius-m)",
    fontFamily: "var(--font)",
  },
  ".cm-tooltip-autocomplete > ul > li[aria-selected]": {
    backgroundColor: "var(--accent)",
    color: "var(--on-accent)",
  },
  ".cm-completionDetail": { fontStyle: "normal", color: "var(--ink-2)" },
  ".cm-diagnostic-error": { borderLeftColor: "var(--alarm)" },
  ".cm-diagnostic-warning": { borderLeftColor: "var(--warning)" },
  // Marks of our own: the library's are pictures in the style sheet, which the page's policy refuses.
  ".cm-lint-marker": {
    content: "normal",
    width: "0.7em",
    height: "0.7em",
    borderRadius: "50%",
    margin: "0.3em 0",
  },
  ".cm-lint-marker-error": { content: "normal", backgroundColor: "var(--alarm)" },
  ".cm-lint-marker-warning": { content: "normal", backgroundColor: "var(--warning)", borderRadius: "0.1em" },
  ".cm-lintRange-error": { backgroundImage: "none", borderBottom: "2px solid var(--alarm)" },
  ".cm-lintRange-warning": { backgroundImage: "none", borderBottom: "2px solid var(--warning)" },
});

const INKS = syntaxHighlighting(
  HighlightStyle.define([
    { tag: [tags.propertyName, tags.definition(tags.propertyName)], color: "var(--trace)" },
    { tag: tags.comment, color: "var(--ink-2)", fontStyle: "italic" },
    { tag: [tags.string, tags.content], color: "var(--ink)" },
    { tag: [tags.punctuation, tags.bracket], color: "var(--ink-2)" },
  ]),
);

/** A key's command that is always its own, whether or not there was something to do. */
function doing(act: () => void): () => true {
  return () => {
    act();
    return true;
  };
}

export function makeEditor(root: ShadowRoot, text: string, typed: (text: string) => void): EditorView {
  const view = new EditorView({
    root,
    parent: root,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        lintGutter(),
        drawSelection(),
        highlightActiveLine(),
        closeBrackets(),
        yaml(),
        indentUnit.of("  "),
        INKS,
        LOOK,
        autocompletion({ override: [complete] }),
        EditorView.contentAttributes.of({ "aria-label": "Mission as YAML" }),
        keymap.of([
          { key: "Mod-z", run: doing(undo), preventDefault: true },
          { key: "Mod-y", run: doing(redo), preventDefault: true },
          { key: "Mod-Shift-z", run: doing(redo), preventDefault: true },
          ...completionKeymap,
          ...lintKeymap,
          ...defaultKeymap,
          indentWithTab,
        ]),
        EditorView.updateListener.of((update) => {
          const own = update.transactions.some(
            (one) => one.docChanged && one.annotation(Transaction.userEvent),
          );
          if (own) typed(update.state.doc.toString());
        }),
      ],
    }),
  });
  view.scrollDOM.tabIndex = 0; // it scrolls, so the keyboard must reach it
  return view;
}
