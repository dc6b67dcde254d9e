// The document as text: problems in the margin, completion from the declared fields, one history with the views.

import { setDiagnostics } from "@codemirror/lint";
import type { EditorView } from "@codemirror/view";
import { useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { plan } from "../fly/forecast";
import { withEnds } from "../model/document";
import { broken, setText, text } from "../model/plan";
import { difference } from "./difference";
import { jump } from "./jump";
import { problemsIn } from "./problems";
import { makeEditor } from "./setup";
import "./yaml_editor.css";

/** The editor's own line ends. */
function shown(of: string): string {
  return withEnds(of, "");
}

export function YamlEditor() {
  const box = useRef<HTMLDivElement>(null);
  const editor = useRef<EditorView | undefined>(undefined);
  useEffect(() => {
    if (!box.current) return;
    // In a shadow root the editor's styles are sheets of its own, which the page's policy allows.
    const root = box.current.shadowRoot ?? box.current.attachShadow({ mode: "open" });
    const view = makeEditor(root, shown(text.peek()), (typed) =>
      setText(withEnds(typed, text.peek()), "Edit the text", "typing"),
    );
    editor.current = view;
    return () => {
      view.destroy();
      editor.current = undefined;
    };
  }, []);
  useSignalEffect(() => {
    const next = text.value;
    const view = editor.current;
    if (!view) return;
    const change = difference(view.state.doc.toString(), shown(next));
    if (change) view.dispatch({ changes: change });
  });
  useSignalEffect(() => {
    const forecast = plan.current.value ? plan.forecast.value : undefined;
    const wrong = broken.value;
    const view = editor.current;
    if (!view) return;
    view.dispatch(setDiagnostics(view.state, problemsIn(view.state.doc, wrong, forecast)));
  });
  useSignalEffect(() => {
    const line = jump.value;
    const view = editor.current;
    if (!view || line === undefined) return;
    const { from, to } = view.state.doc.line(Math.min(Math.max(1, line), view.state.doc.lines));
    view.dispatch({ selection: { anchor: from, head: to }, scrollIntoView: true });
    jump.value = undefined;
  });
  return <div class="yaml-editor" ref={box} />;
}
