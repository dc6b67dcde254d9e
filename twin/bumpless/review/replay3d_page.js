// The report's own use of the view: its data stand in the page as JSON, a slider and buttons move it.
const data = JSON.parse(document.getElementById("replay3d-data").textContent);
const find = (id) => document.getElementById(id);
const slider = find("replay3d-time");
const shown = new View3d(find("replay3d"), data, data.look);
let [playing, before] = [false, 0];

function to(t) {
  slider.value = t;
  shown.draw(t);
}

function tick(now) {
  if (!playing) return;
  const t = Number(slider.value) + ((now - before) / 1000) * Number(find("replay3d-speed").value);
  before = now;
  to(Math.min(t, Number(slider.max)));
  if (t >= Number(slider.max)) play(false);
  else requestAnimationFrame(tick);
}

function play(on) {
  playing = on;
  before = performance.now();
  find("replay3d-play").textContent = on ? "Pause" : "Play";
  if (on && Number(slider.value) >= Number(slider.max)) to(Number(slider.min));
  if (on) requestAnimationFrame(tick);
}

slider.addEventListener("input", () => shown.draw(Number(slider.value)));
find("replay3d-play").addEventListener("click", () => play(!playing));
for (const button of document.querySelectorAll("[data-view]")) {
  button.addEventListener("click", () => shown.view(button.dataset.view));
}
addEventListener("resize", () => shown.draw(shown.time));
shown.view("overview");
