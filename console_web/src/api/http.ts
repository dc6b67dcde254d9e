// Requests to the server. Refusals are values, not exceptions: the page shows them as they came.

import type { Problem } from "./types";

export interface Refusal {
  ok: false;
  /** HTTP status; 0 when the server did not answer. */
  status: number;
  /** One sentence for the operator, verbatim from the vehicle where it has one. */
  reason: string;
  problems: Problem[];
}
export type Answer<T> = { ok: true; value: T } | Refusal;

const TIMEOUT_MS = 15_000;

/** What a request can say besides. */
export interface More {
  headers?: Record<string, string>;
  /** Patience with work that takes the server longer than an answer. */
  timeoutMs?: number;
}

function text(value: unknown): string {
  return value === undefined || value === null
    ? ""
    : typeof value === "string"
      ? value
      : JSON.stringify(value);
}

function problemsOf(body: Record<string, unknown>): Problem[] {
  const list = Array.isArray(body.problems) ? (body.problems as Record<string, unknown>[]) : [];
  return list.map((p) => ({
    file: text(p.file),
    line: Number(p.line ?? 0),
    column: Number(p.column ?? 0),
    field: text(p.field),
    value: text(p.value),
    rule: text(p.rule),
  }));
}

function refusal(status: number, statusText: string, raw: string): Refusal {
  let body: Record<string, unknown> = {};
  try {
    const parsed: unknown = JSON.parse(raw);
    if (parsed && typeof parsed === "object") body = parsed as Record<string, unknown>;
  } catch {
    body = { detail: raw.slice(0, 300) };
  }
  const detail = body.detail;
  if (detail && typeof detail === "object" && !Array.isArray(detail))
    body = { ...body, ...(detail as object) };
  const sentence = [body.reason, body.detail, body.title].find((part) => typeof part === "string" && part);
  const problems = problemsOf(body);
  const reason =
    text(sentence) || (problems.length ? `${problems.length} problem(s)` : `${status} ${statusText}`);
  return { ok: false, status, reason, problems };
}

/** The session is over: nothing of the page works any more but the login. The view stays in the address. */
function loggedOut(): void {
  if (typeof location !== "undefined") location.replace(`./login${location.hash}`);
}

const UNREADABLE = Symbol("not JSON");

/** An answer that is no JSON comes from a server that is there: it is not out of reach. */
function parsed<T>(raw: string): T | typeof UNREADABLE {
  try {
    return JSON.parse(raw) as T;
  } catch {
    return UNREADABLE;
  }
}

export async function request<T>(
  method: string,
  path: string,
  body?: string | Blob | object,
  { headers = {}, timeoutMs = TIMEOUT_MS }: More = {},
): Promise<Answer<T>> {
  const init: RequestInit = { method, signal: AbortSignal.timeout(timeoutMs), cache: "no-store", headers };
  if (body instanceof Blob) {
    init.body = body;
  } else if (typeof body === "string") {
    init.body = body;
    init.headers = { ...headers, "content-type": "text/plain; charset=utf-8" };
  } else if (body !== undefined) {
    init.body = JSON.stringify(body);
    init.headers = { ...headers, "content-type": "application/json" };
  }
  try {
    const response = await fetch(path, init);
    const raw = await response.text();
    if (response.status === 401 && path !== "api/me/password") loggedOut();
    if (!response.ok) return refusal(response.status, response.statusText, raw);
    const value = raw ? parsed<T>(raw) : (undefined as T);
    if (value === UNREADABLE) return refusal(response.status, "the server's answer cannot be read", "");
    const reply = value as { accepted?: boolean } | undefined;
    if (reply && typeof reply === "object" && reply.accepted === false) return refusal(200, "refused", raw);
    return { ok: true, value };
  } catch (error) {
    const late = error instanceof DOMException && error.name === "TimeoutError";
    const reason = late
      ? `The server did not answer within ${timeoutMs / 1000} s.`
      : "The server cannot be reached.";
    return { ok: false, status: 0, reason, problems: [] };
  }
}
