// Requests whose paths, queries, bodies and answers are those of the server's interface.
import type { paths } from "../gen/api";
import { type Answer, type More, request } from "./http";

type Method = "get" | "put" | "post" | "delete";
type PathsWith<M extends Method> = {
  [P in keyof paths]: paths[P] extends Record<M, { responses: unknown }> ? P : never;
}[keyof paths];
type Operation<P extends keyof paths, M extends Method> = M extends keyof paths[P] ? paths[P][M] : never;
type Json<T> = T extends { content: { "application/json": infer J } } ? J : undefined;
type Good<O> = O extends { responses: infer R } ? Json<R[keyof R & (200 | 201 | 204)]> : never;
type Names<P extends string> = P extends `${string}{${infer N}}${infer Rest}` ? N | Names<Rest> : never;
type Query<O> = O extends { parameters: { query?: infer Q } } ? Q : never;
/** As declared; any bytes where they are no JSON or not declared. */
type Body<O> = O extends { requestBody: { content: { "application/json": infer B } } }
  ? B
  : string | Blob | object;

interface Options<P extends string, O> extends More {
  path?: Record<Names<P>, string>;
  query?: Query<O>;
  body?: Body<O>;
}

/** The address of a path with its parts filled in, relative to the page. */
export function address(path: string, parts: Record<string, string> = {}, query: object = {}): string {
  const filled = path
    .slice(1)
    .replace(/\{(\w+)\}/g, (_, name: string) => encodeURIComponent(parts[name] ?? ""));
  const pairs = Object.entries(query).map(([name, value]) => [name, String(value)]);
  return pairs.length ? `${filled}?${new URLSearchParams(pairs)}` : filled;
}

export function ask<M extends Method, P extends PathsWith<M> & string>(
  method: M,
  path: P,
  options: Options<P, Operation<P, M>> = {},
): Promise<Answer<Good<Operation<P, M>>>> {
  const to = address(path, options.path, options.query as object | undefined);
  return request(method.toUpperCase(), to, options.body as string | Blob | object | undefined, options);
}
