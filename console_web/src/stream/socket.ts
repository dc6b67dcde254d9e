// The stream's WebSocket: binary frames in, nothing out; reconnects by itself.
import type { LiveStore } from "./store";

const FIRST_RETRY_MS = 400;
const LAST_RETRY_MS = 4000;
/** The server says something twice a second: a socket silent for this long is dead. */
const SILENCE_MS = 3000;

function streamUrl(): string {
  const url = new URL("./api/stream", location.href);
  url.protocol = url.protocol === "https:" ? "wss:" : "ws:";
  url.hash = "";
  return url.href;
}

/** Keep `store` connected for as long as the page lives. */
export function connect(store: LiveStore): void {
  let retryMs = FIRST_RETRY_MS;
  let timer: ReturnType<typeof setTimeout> | undefined;

  const lost = (): void => {
    store.lose(retryMs);
    clearTimeout(timer);
    timer = setTimeout(open, retryMs);
    retryMs = Math.min(LAST_RETRY_MS, retryMs * 1.7);
  };

  const open = (): void => {
    clearTimeout(timer);
    const socket = new WebSocket(streamUrl());
    socket.binaryType = "arraybuffer";
    let silence: ReturnType<typeof setTimeout> | undefined;
    const listen = (): void => {
      clearTimeout(silence);
      silence = setTimeout(() => socket.close(), SILENCE_MS);
    };
    let ended = false;
    const end = (): void => {
      if (ended) return;
      ended = true;
      clearTimeout(silence);
      lost();
    };
    socket.onopen = listen;
    socket.onmessage = (event: MessageEvent<ArrayBuffer>) => {
      listen();
      retryMs = FIRST_RETRY_MS;
      store.receive(new Uint8Array(event.data));
    };
    socket.onclose = end;
  };

  addEventListener("online", () => {
    if (store.connection.peek() === "lost") open();
  });
  open();
}
