// Runs before viser's client. Makes the page fit the console and tell the truth about its own link.
(() => {
  const root = document.documentElement;
  const query = new URLSearchParams(location.search);
  const theme = query.get("theme") === "light" ? "light" : "dark";
  root.dataset.theme = theme;
  root.dataset.link = "connecting";

  // viser retries a lost socket only while the page has focus, which an iframe rarely has.
  Document.prototype.hasFocus = () => true;

  // viser also loads a sorter for Gaussian splats, which our policy stops because it evaluates strings.
  // Nothing here is a splat.
  addEventListener("unhandledrejection", (event) => {
    if (event.reason instanceof EvalError) event.preventDefault();
  });

  // viser reads its own settings from the address.
  const params = new URLSearchParams();
  params.set("theme", theme);
  if (theme === "dark") params.set("darkMode", "1");
  const light = query.get("quality") === "light";
  if (light) params.set("quality", "light");
  params.set("fixedDpr", light ? "1" : String(Math.min(window.devicePixelRatio || 1, 2)));
  history.replaceState(null, "", `${location.pathname}?${params}`);

  // viser's labels are black on white by shader; on a dark background they become light on dark.
  const ink = theme === "dark" ? "vec4(0.88, 0.93, 0.97, a)" : "vec4(0.07, 0.11, 0.16, a)";
  const paper = theme === "dark" ? "vec4(0.045, 0.085, 0.125, 0.72 * vAlpha)" : "vec4(1.0, 1.0, 1.0, 0.72 * vAlpha)";
  const shaderSource = WebGL2RenderingContext.prototype.shaderSource;
  WebGL2RenderingContext.prototype.shaderSource = function (shader, source) {
    const themed = source
      .replace("vec4(0.0, 0.0, 0.0, a)", ink)
      .replace("vec4(1.0, 1.0, 1.0, 0.85 * vAlpha)", paper);
    return shaderSource.call(this, shader, themed);
  };

  // The server sends something at least every second. Silence means that this picture is old.
  const SILENCE_MS = 2500;
  let silence = 0;
  const show = (link) => { root.dataset.link = link; };
  const heard = () => {
    clearTimeout(silence);
    silence = setTimeout(() => show("lost"), SILENCE_MS);
    if (root.dataset.link !== "live") show("live");
  };
  const PlainWorker = window.Worker;
  window.Worker = class extends PlainWorker {
    constructor(...args) {
      super(...args);
      this.addEventListener("message", ({ data }) => {
        if (data?.type === "message_batch") heard();
        else if (data?.type === "closed" && root.dataset.link === "live") show("lost");
      });
    }
  };

  // What cannot be seen is not drawn: frames are held back while the console shows another view, and viser is
  // told that the page is hidden, so that it takes in what comes without waiting for a frame. The picture is
  // up to date in the first frame after.
  let seen = true;
  let lastHeld = 0;
  const held = new Map(); // our number of a frame asked for while unseen -> what to call
  const plainRequest = window.requestAnimationFrame.bind(window);
  const plainCancel = window.cancelAnimationFrame.bind(window);
  window.requestAnimationFrame = (draw) => {
    if (seen) return plainRequest(draw);
    held.set(--lastHeld, draw); // below zero, where the browser has no numbers
    return lastHeld;
  };
  window.cancelAnimationFrame = (number) => {
    if (!held.delete(number)) plainCancel(number);
  };
  const isHidden = Object.getOwnPropertyDescriptor(Document.prototype, "hidden").get;
  Object.defineProperty(Document.prototype, "hidden", {
    configurable: true,
    get() { return !seen || isHidden.call(this); },
  });
  new IntersectionObserver((entries) => {
    seen = entries.at(-1).isIntersecting;
    root.dataset.seen = seen ? "yes" : "no";
    if (!seen) return;
    for (const draw of held.values()) plainRequest(draw);
    held.clear();
  }).observe(root);

  const LEGEND = __LEGEND__; // [colour, name] in order

  addEventListener("DOMContentLoaded", () => {
    const legend = document.createElement("aside"); // a landmark: it belongs to no other
    legend.id = "scene-legend";
    legend.setAttribute("aria-label", "Legend");
    for (const [colour, name] of LEGEND) {
      const mark = document.createElement("i");
      mark.style.background = colour;
      const entry = document.createElement("span");
      entry.append(mark, name);
      legend.append(entry);
    }
    document.body.append(legend);
    const note = document.createElement("div");
    note.id = "scene-link";
    note.setAttribute("role", "status");
    const text = () => {
      note.textContent = root.dataset.link === "lost" ? "Scene link lost · picture is not live" : "Connecting to scene…";
    };
    new MutationObserver(text).observe(root, { attributes: true, attributeFilter: ["data-link"] });
    text();
    document.body.append(note);
  });
})();
