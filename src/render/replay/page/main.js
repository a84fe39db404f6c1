// The player: time, input, and when to draw.

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8];
const KEYS = [["space", "play, pause"], ["\u2190 \u2192", "a step; with Shift ten"], ["Home End", "first, last step"], ["[ ]", "slower, faster"],
              ["+ \u2212", "zoom"], ["0", "first view"], ["F", "follow the chosen body"], ["/", "find a body"], ["Esc", "choose none"],
              ["drag", "move the view"], ["wheel, pinch", "zoom"], ["click, tap", "choose a body"]];

class Player {
  constructor(run) {
    this.run = run;
    this.step = 0;
    this.chosen = -1;
    this.claim = null;
    this.playing = false;
    this.speed = 1;
    this.framesDrawn = 0;
    this.on = Object.fromEntries(OVERLAYS.map((overlay) => [overlay.id, overlay.on === true]));
    this.camera = new Camera(run);
    this.painter = new Painter(byId("world"), run, this.camera);
    this.overlays = new OverlayPainter(this.painter);
    this.panel = new Panel(this);
    this.timeline = new Timeline(this);
    byId("scrubber").max = run.last_step;
    this.describe();
    this.makeControls();
    this.listenToPointers();
    document.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.resize()).observe(byId("stage"));
    this.resize();
  }

  describe() {
    const bodies = this.run.bodies.length;
    document.title = `${this.run.name || "tumble"} \u2013 replay`;
    byId("name").textContent = this.run.name || "tumble replay";
    byId("summary").textContent = `${bodies} ${bodies === 1 ? "body" : "bodies"}, ${this.run.last_step} steps, ${fixed(this.run.last_step / this.run.steps_per_second, 2)} s` +
      (this.run.complete ? "" : ", ended early");
  }

  makeControls() {
    for (const overlay of OVERLAYS) this.makeOverlay(overlay);
    for (const speed of SPEEDS) byId("speed").append(new Option(`${speed}\u00d7`, speed, speed === 1, speed === 1));
    byId("speed").addEventListener("change", () => { this.speed = Number(byId("speed").value); });
    for (const [key, meaning] of KEYS) {
      const row = element("tr");
      row.append(element("td"), element("td", "", meaning));
      row.firstChild.append(element("kbd", "", key));
      byId("keys").append(row);
    }
    byId("play").addEventListener("click", () => this.toggle());
    byId("back").addEventListener("click", () => this.seek(this.wholeStep() - 1));
    byId("forward").addEventListener("click", () => this.seek(this.wholeStep() + 1));
    byId("scrubber").addEventListener("input", () => this.seek(Number(byId("scrubber").value)));
    byId("fit").addEventListener("click", () => { this.camera.fit(); this.redraw(); });
    byId("theme").addEventListener("click", () => this.setTheme(this.painter.theme.dark ? "light" : "dark"));
    byId("panel-button").addEventListener("click", () => this.togglePanel());
    document.addEventListener("pointerdown", (event) => {
      for (const popup of document.querySelectorAll("details[open]")) if (!popup.contains(event.target)) popup.open = false;
    });
  }

  makeOverlay(overlay) {
    const label = element("label"), box = element("input"), swatch = element("i", "swatch");
    const missing = overlay.needsContacts === true && byId("contacts").textContent === "";
    box.type = "checkbox";
    box.id = `overlay-${overlay.id}`;
    box.checked = this.on[overlay.id];
    box.disabled = missing;
    box.addEventListener("change", () => { this.on[overlay.id] = box.checked; this.redraw(); });
    swatch.style.background = overlay.color ? `var(--${overlay.color})` : "transparent";
    label.append(box, swatch, element("span", "", overlay.text), element("kbd", "", overlay.key.toUpperCase()));
    label.classList.toggle("off", missing);
    if (missing) label.title = "The replay was made without contacts.";
    byId("overlay-list").append(label);
  }

  setTheme(name) {
    document.documentElement.dataset.theme = name;
    this.painter.theme = new Theme();
    byId("theme").textContent = name === "dark" ? "Light" : "Dark";
    this.resize();
  }

  togglePanel(shown = byId("panel").hidden) {
    byId("panel").hidden = !shown;
    byId("panel-button").setAttribute("aria-expanded", String(shown));
    this.redraw();
  }

  // Time.

  wholeStep() { return Math.floor(this.step + 1e-9); }
  timeText(step) { return `${fixed(step / this.run.steps_per_second, 2)} s`; }

  seek(step) {
    this.pause();
    this.step = Math.min(this.run.last_step, Math.max(0, Math.round(step)));
    this.redraw();
  }

  play() {
    if (this.step >= this.run.last_step) this.step = 0;
    this.playing = true;
    this.lastTime = undefined;
    this.showPlaying();
    this.redraw();
  }

  pause() {
    if (this.playing) this.step = this.wholeStep();
    this.playing = false;
    this.showPlaying();
  }

  toggle() { if (this.playing) this.pause(); else this.play(); this.redraw(); }

  showPlaying() {
    byId("play").textContent = this.playing ? "\u275a\u275a" : "\u25b6\ufe0e";
    byId("play").setAttribute("aria-label", this.playing ? "Pause" : "Play");
  }

  advance(now) {
    const seconds = Math.min(0.25, (now - (this.lastTime ?? now)) / 1000);
    this.lastTime = now;
    this.step = Math.min(this.run.last_step, this.step + seconds * this.speed * this.run.steps_per_second);
    if (this.step >= this.run.last_step) this.pause();
  }

  changeSpeed(by) {
    const index = Math.min(SPEEDS.length - 1, Math.max(0, SPEEDS.indexOf(this.speed) + by));
    this.speed = SPEEDS[index];
    byId("speed").value = String(this.speed);
  }

  // Choice.

  choose(number, moveTo = false) {
    this.chosen = number;
    if (this.camera.following >= 0) this.camera.following = number;
    if (number >= 0 && moveTo) this.bringIntoView(number);
    if (number >= 0) byId("panel").hidden = false;
    this.redraw();
  }

  bringIntoView(number) {
    const step = this.wholeStep();
    if (!this.run.exists(number, step)) return;
    const pose = this.run.pose(number, step);
    if (!this.painter.isInView(pose, 0)) this.camera.moveTo(pose.x, pose.y);
  }

  toggleFollow() {
    this.camera.follow(this.camera.following === this.chosen ? -1 : this.chosen);
    this.redraw();
  }

  showClaim(claim) {
    this.claim = claim;
    this.seek(claim.step);
    this.say(`${claim.passed ? "Holds" : "Fails"} at ${this.timeText(claim.step)}: ${claim.claim}. Found: ${claim.finding}`, claim.passed ? "good" : "bad");
    for (const other of this.run.claims) other.item.classList.toggle("chosen", other === claim);
  }

  showEvent(event) {
    this.seek(event.step);
    this.say(`${this.timeText(event.step)}: ${event.text}`);
  }

  say(text, kind = "") {
    byId("message").textContent = text;
    byId("message").className = kind;
    byId("message").hidden = text === "";
  }

  // Input.

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const typing = event.target.matches("input[type=search], select");
    const acts = event.key === " " && event.target.matches("button, summary, input[type=checkbox]");
    if (event.key === "Escape") {
      this.claim = null;
      this.say("");
      this.choose(-1);
      event.target.blur();
      return;
    }
    if (typing || acts) return;  // the control itself answers the key
    const jump = event.shiftKey ? 10 : 1;
    const actions = { " ": () => this.toggle(), ArrowLeft: () => this.seek(this.wholeStep() - jump), ArrowRight: () => this.seek(this.wholeStep() + jump),
                      Home: () => this.seek(0), End: () => this.seek(this.run.last_step), "+": () => this.camera.zoom(1.25, this.step), "=": () => this.camera.zoom(1.25, this.step),
                      "-": () => this.camera.zoom(0.8, this.step), 0: () => this.camera.fit(), "[": () => this.changeSpeed(-1), "]": () => this.changeSpeed(1),
                      f: () => { if (this.chosen >= 0) this.toggleFollow(); }, "/": () => { this.togglePanel(true); this.panel.show("bodies"); byId("search").focus(); } };
    const overlay = OVERLAYS.find((one) => one.key === event.key.toLowerCase());
    if (overlay && !byId(`overlay-${overlay.id}`).disabled) byId(`overlay-${overlay.id}`).click();
    else if (actions[event.key]) actions[event.key]();
    else return;
    event.preventDefault();
    this.redraw();
  }

  listenToPointers() {
    const canvas = byId("world"), down = new Map();
    let moved = 0;
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.camera.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)), this.step, event.offsetX, event.offsetY);
      this.redraw();
    }, { passive: false });
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      if (down.size === 0) moved = 0;
      down.set(event.pointerId, [event.offsetX, event.offsetY]);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!down.has(event.pointerId)) return;
      const before = down.get(event.pointerId), after = [event.offsetX, event.offsetY];
      moved += Math.hypot(after[0] - before[0], after[1] - before[1]);
      this.drag([...down.values()], before, after);
      down.set(event.pointerId, after);
      this.redraw();
    });
    const release = (event) => {
      const isTap = down.size === 1 && moved < 6 && event.type === "pointerup";
      down.delete(event.pointerId);
      if (isTap) this.choose(bodyAt(this.painter, this.camera.world(event.offsetX, event.offsetY), this.wholeStep(), 6 / this.camera.scale));
    };
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
  }

  // One finger moves the view, two also zoom it about their middle.
  drag(points, before, after) {
    if (points.length === 1) {
      this.camera.pan(after[0] - before[0], after[1] - before[1]);
      return;
    }
    const other = points.find((point) => point !== before);
    const apart = (point) => Math.hypot(point[0] - other[0], point[1] - other[1]);
    this.camera.pan((after[0] - before[0]) / 2, (after[1] - before[1]) / 2);
    this.camera.zoom(apart(after) / Math.max(1, apart(before)), this.step, (after[0] + other[0]) / 2, (after[1] + other[1]) / 2);
  }

  // Drawing.

  resize() {
    this.painter.resize();
    this.timeline.draw();
    this.redraw();
  }

  redraw() {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame((now) => {
      this.scheduled = false;
      if (this.playing) this.advance(now);
      this.draw();
      if (this.playing) this.redraw();
    });
  }

  draw() {
    this.camera.show(this.step);
    this.painter.clear();
    this.painter.grid();
    const islands = this.on.islands && this.run.contacts ? this.run.islands(this.wholeStep()) : [];
    this.painter.bodies(this.step, islands, this.on.sleeping);
    if (this.chosen >= 0) this.painter.outline(this.chosen, this.step, this.painter.theme.accent, 3.5);
    this.drawOverlays();
    this.drawTexts();
    this.framesDrawn++;
  }

  drawOverlays() {
    this.painter.usePixels();
    if (this.on.boxes) this.overlays.boxes(this.step);
    if (this.on.trails) this.overlays.trails(this.step, this.chosen);
    if (this.on.joints) this.overlays.joints(this.step);
    if (this.on.velocities) this.overlays.velocities(this.step);
    if (this.run.contacts && (this.on.contacts || this.on.normals)) this.overlays.contacts(this.step, this.on);
    if (this.claim) this.overlays.claim(this.claim, this.step);
  }

  drawTexts() {
    const step = this.wholeStep(), bar = roundLength(60 / this.camera.scale).metres;
    byId("scrubber").value = step;
    byId("clock").replaceChildren(this.timeText(step), element("span", "", ` step ${step} of ${this.run.last_step}`));
    byId("legend").replaceChildren(`${bar >= 1000 ? `${bar / 1000} km` : bar >= 1 ? `${bar} m` : `${Number((bar * 100).toPrecision(1))} cm`}`, element("i"));
    byId("legend").lastChild.style.width = `${bar * this.camera.scale}px`;
    if (byId("panel").hidden) return;
    this.panel.values();
    if (!this.playing || this.framesDrawn % 12 === 0) this.panel.rows();
  }
}

async function start() {
  const states = unpackStates(await inflate("states"));
  const wide = matchMedia("(min-width: 761px)").matches;
  document.documentElement.dataset.theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  byId("panel").hidden = !wide;
  const player = new Player(new Run(states, null));
  player.setTheme(document.documentElement.dataset.theme);
  player.say("");
  return player;
}

// There may be more contact points than poses: they are unpacked when the page is already in use.
async function addContacts(player) {
  await new Promise((done) => setTimeout(done));
  const bytes = await inflate("contacts");
  if (bytes) player.run.contacts = unpackContacts(bytes);
  player.redraw();
  return player;
}

function fail(error) {
  byId("message").textContent = `This replay cannot be shown: ${error.message}`;
  byId("message").className = "bad";
  throw error;
}

// For scripts: await replay.whole, then replay.player.seek(120), replay.player.run.pose(3, 120). `ready` comes before
// `whole`, without the contacts.
const ready = start().then((player) => (window.replay.player = player), fail);
window.replay = { player: null, ready, whole: ready.then(addContacts).catch(fail) };
