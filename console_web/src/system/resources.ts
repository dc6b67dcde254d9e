// What this view alone asks the server for.
import { ask } from "../api/client";
import { Resource } from "../api/resource";

export const diagnostics = new Resource(() => ask("get", "/api/diagnostics"));
export const audit = new Resource(() => ask("get", "/api/audit", { query: { limit: 500 } }));
export const users = new Resource(() => ask("get", "/api/users"));
export const sessions = new Resource(() => ask("get", "/api/sessions"));
export const tokens = new Resource(() => ask("get", "/api/tokens"));

/** Each of the three tells something of the others. */
export function refreshPeople(): void {
  void users.refresh();
  void sessions.refresh();
  void tokens.refresh();
}
