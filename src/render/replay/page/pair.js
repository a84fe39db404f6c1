// The player of two runs: both worlds with one view, and plots of their differences.

class PairPlayer extends Playback {
  constructor(runs, numbers) {
    super(Math.min(runs[0].last_step, runs[1].last_step), runs[0].steps_per_second);
    this.runs = runs;
    this.numbers = numbers;
    this.on = { overlaid: false, velocities: false, trails: false };
    this.camera = new Camera(runs[0]);
    this.painters = runs.map((run, i) => new Painter(this.canvas(i), run, this.camera));
    this.overlays = this.painters.map((painter) => new OverlayPainter(painter));
    this.plots = ["distance", "energy"].map((id) => new TimePlot(byId(id), this.lastStep, (step) => this.seek(step)));
    this.describe();
    this.makeControls();
    for (const i of [0, 1]) movePointers(this.canvas(i), this.camera, this, () => {});
    document.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.resize()).observe(byId("stage"));
    this.resize();
  }

  canvas(i) { return byId(i === 0 ? "world-a" : "world-b"); }

  describe() {
    document.title = byId("name").textContent = this.numbers.title || "tumble compare";
    byId("summary").textContent = `${this.lastStep} steps, ${this.timeText(this.lastStep)}`;
    byId("name-a").textContent = this.numbers.names[0];
    byId("name-b").textContent = this.numbers.names[1];
    byId("first").disabled = this.numbers.first === null;
    if (this.numbers.first === null) byId("first").textContent = "No difference";
  }

  makeControls() {
    for (const id of Object.keys(this.on)) byId(id).addEventListener("click", () => this.switch(id));
    byId("first").addEventListener("click", () => this.seek(this.numbers.first));
    byId("fit").addEventListener("click", () => { this.camera.fit(); this.redraw(); });
    byId("theme").addEventListener("click", () => this.setTheme(otherTheme(this.painters[0].theme.name, this.runs[0].theme)));
  }

  switch(id) {
    this.on[id] = !this.on[id];
    byId(id).setAttribute("aria-pressed", String(this.on[id]));
    byId("pair").classList.toggle("overlaid", this.on.overlaid);
    this.resize();
  }

  setTheme(name) {
    applyTheme(name, this.painters);
    this.resize();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || isForControl(event)) return;
    const actions = this.keyActions(this.camera, event.shiftKey ? 10 : 1);
    for (const id of Object.keys(this.on)) actions[id[0]] = () => this.switch(id);
    if (this.numbers.first !== null) actions.d = () => this.seek(this.numbers.first);
    if (!actions[event.key]) return;
    actions[event.key]();
    event.preventDefault();
    this.redraw();
  }

  resize() {
    for (const painter of this.painters) painter.resize();
    this.redraw();
  }

  draw() {
    this.camera.show(this.step);
    this.painters.forEach((painter, i) => {
      painter.clear();
      painter.grid();
      painter.bodies(this.step, [], false);
      painter.usePixels();
      if (this.on.trails) this.overlays[i].trails(this.step, -1);
      this.overlays[i].joints(this.step);
      if (this.on.velocities) this.overlays[i].velocities(this.step);
    });
    this.drawPlots();
    this.showClock();
    this.framesDrawn++;
  }

  drawPlots() {
    const step = this.wholeStep(), { distances, energies, first, names } = this.numbers, theme = this.painters[0].theme;
    const known = (value, unit) => typeof value === "number" ? `${brief(value)} ${unit}` : "unknown";
    this.plots[0].draw(theme, [{ values: distances, from: 0, color: theme.box }], step, first);
    byId("distance-text").textContent = `Largest difference in x or y: ${known(distances[step], "m")}`;
    const curves = energies.map((values, i) => ({ values, from: 0, color: i === 0 ? theme.accent : theme.velocity }));
    this.plots[1].draw(theme, curves, step, first);
    byId("energy-text").replaceChildren("Energy: ", ...curves.flatMap(({ color }, i) => {
      const swatch = element("i", "swatch");
      swatch.style.background = color;
      return [swatch, ` ${names[i]} ${known(energies[i][step], "J")}  `];
    }));
  }
}

async function start() {
  const runs = [];
  for (const id of ["states-a", "states-b"]) runs.push(new Run(unpackStates(await inflate(id)), null));
  const numbers = JSON.parse(new TextDecoder().decode(await inflate("numbers")));
  document.documentElement.dataset.theme = runs[0].theme || systemTheme();
  const player = new PairPlayer(runs, numbers);
  player.setTheme(document.documentElement.dataset.theme);
  byId("message").hidden = true;
  return player;
}

function fail(error) { showFailure("This comparison cannot be shown", error); }

// For scripts: await replay.whole, then replay.player.seek(120), replay.player.runs[1].pose(3, 120).
const ready = start().then((player) => (window.replay.player = player)).catch(fail);
window.replay = { player: null, ready, whole: ready };
