// A mission's text and how it is edited: a number is replaced where it stands, and whatever changes the
// structure goes through the YAML document, so that comments, order and the rest of the text stay.
import {
  type Document,
  isCollection,
  isMap,
  isPair,
  isScalar,
  isSeq,
  parseDocument,
  type YAMLMap,
} from "yaml";
import type { Path } from "./paths";

/** Put `value` at `path`; undefined takes it away. */
export interface Edit {
  path: Path;
  value: unknown;
}

export function read(text: string): Document {
  return parseDocument(text, { prettyErrors: false, logLevel: "silent" });
}

/** As the file's own style has it: two or four spaces, lists indented or not. */
export function write(doc: Document, like: string): string {
  const indent = /^( +)[A-Za-z_]/m.exec(like)?.[1]?.length ?? 2;
  const flatLists = /^[A-Za-z_]\w*:[^\n]*\n- /m.test(like);
  const made = doc.toString({
    lineWidth: 0,
    flowCollectionPadding: false,
    indent: Math.min(indent, 8),
    indentSeq: !flatLists,
  });
  const mark = like.startsWith(BOM) && !made.startsWith(BOM) ? BOM : "";
  return mark + withEnds(made, like);
}

const BOM = "\uFEFF";

/** Line ends as another text has them. */
export function withEnds(text: string, like: string): string {
  const plain = text.replaceAll("\r\n", "\n");
  return like.includes("\r\n") ? plain.replaceAll("\n", "\r\n") : plain;
}

/** A number in few characters: at most three decimals, never -0. */
export function short(value: number, decimals = 3): number {
  return Number(value.toFixed(decimals)) + 0;
}

function scalarText(value: unknown): string | undefined {
  if (typeof value === "number" && Number.isFinite(value)) return String(value);
  if (typeof value === "boolean") return String(value);
  return undefined;
}

/** Where the number at `path` stands in the text. */
function placeOf(doc: Document, path: Path): readonly [number, number] | undefined {
  const node = doc.getIn(path, true);
  if (!isScalar(node) || !node.range || node.anchor || node.tag?.startsWith("!")) return undefined;
  return [node.range[0], node.range[1]];
}

/** The text with every edit made. Later edits see what earlier ones did. */
export function edited(text: string, edits: readonly Edit[], doc: Document = read(text)): string {
  const splices: { from: number; to: number; put: string }[] = [];
  for (const { path, value } of edits) {
    const place = placeOf(doc, path);
    const put = scalarText(value);
    if (!place || put === undefined) return restructured(text, (fresh) => setAll(fresh, edits));
    splices.push({ from: place[0], to: place[1], put });
  }
  splices.sort((a, b) => b.from - a.from);
  return splices.reduce((made, { from, to, put }) => made.slice(0, from) + put + made.slice(to), text);
}

/** The text after a change of the document's structure. */
export function restructured(text: string, change: (doc: Document) => void): string {
  const doc = read(text);
  change(doc);
  return write(doc, text);
}

function setAll(doc: Document, edits: readonly Edit[]): void {
  for (const { path, value } of edits) put(doc, path, value);
}

/** Set or remove one value, making the tables on the way, and taking away those left empty. */
export function put(doc: Document, path: Path, value: unknown): void {
  if (value === undefined) {
    doc.deleteIn(path);
    for (let end = path.length - 1; end > 0; end--) {
      const parent = doc.getIn(path.slice(0, end));
      if (!isMap(parent) || parent.items.length > 0) break;
      doc.deleteIn(path.slice(0, end));
    }
    return;
  }
  if (doc.contents === null) doc.contents = doc.createNode({}) as YAMLMap as never;
  for (let end = 1; end < path.length; end++) {
    const parent = doc.getIn(path.slice(0, end));
    if (isCollection(parent)) continue;
    doc.setIn(path.slice(0, end), doc.createNode(typeof path[end] === "number" ? [] : {}));
  }
  const present = doc.getIn(path, true);
  if (isScalar(present) && !isCollection(value) && (typeof value !== "object" || value === null)) {
    present.value = value;
    return;
  }
  const node = styled(doc, value);
  if (typeof path.at(-1) === "number" && isMap(node)) node.flow = true; // an entry of a list
  doc.setIn(path, node);
}

/** A value as people write it: rows and entries of lists on one line. */
export function styled(doc: Document, value: unknown): unknown {
  const node = doc.createNode(value);
  if (isSeq(node)) {
    const row = node.items.every((item) => isScalar(item));
    if (row) node.flow = true;
    else for (const item of node.items) if (isCollection(item)) item.flow = true;
  }
  if (isMap(node)) {
    for (const pair of node.items)
      if (isPair(pair) && isSeq(pair.value) && pair.value.items.every((item) => isScalar(item)))
        pair.value.flow = true;
  }
  return node;
}

/** A plain value with edits made: what a view shows while something is dragged, without reading text again. */
export function patched(value: unknown, edits: readonly Edit[]): unknown {
  return edits.reduce<unknown>((made, { path, value: put }) => patch(made, path, put), value);
}

function patch(value: unknown, path: Path, put: unknown): unknown {
  const [key, ...rest] = path;
  if (key === undefined) return put;
  const inner = patch((value as Record<string | number, unknown> | undefined)?.[key], rest, put);
  if (Array.isArray(value)) return value.map((item, index) => (index === key ? inner : item));
  return { ...(value as object), [key]: inner };
}
