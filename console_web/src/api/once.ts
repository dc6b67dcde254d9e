/** Names a request: the server does the same one once, however often it comes. */
export function once(): Record<string, string> {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  const name = Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
  return { "idempotency-key": name };
}
