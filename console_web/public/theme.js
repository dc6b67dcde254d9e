// Runs before the first paint so that the page never flashes in the wrong theme.
(function () {
  var stored = null;
  try {
    stored = localStorage.getItem("bumpless.theme");
  } catch (_) {
    // Storage may be switched off: the system's preference decides.
  }
  var light = window.matchMedia("(prefers-color-scheme: light)").matches;
  document.documentElement.dataset.theme = stored || (light ? "light" : "dark");
})();
