// The player of one run: choice, input, and what to draw.

const KEYS = [["space", "play, pause"], ["\u2190 \u2192", "a step; with Shift ten"], ["Home End", "first, last step"], ["[ ]", "slower, faster"],
              ["+ \u2212", "zoom"], ["0", "first view"], ["F", "follow the chosen body"], ["/", "find a body"], ["Esc", "choose none"],
              ["drag", "move the view"], ["wheel, pinch", "zoom"], ["click, tap", "choose a body"]];

class Player extends Playback {
  constructor(run) {
    super(run.last_step, run.steps_per_second);
    this.run = run;
    this.chosen = -1;
    this.claim = null;
    this.on = Object.fromEntries(OVERLAYS.map((overlay) => [overlay.id, overlay.on === true]));
    this.camera = new Camera(run);
    this.painter = new Painter(byId("world"), run, this.camera);
    this.overlays = new OverlayPainter(this.painter);
    this.panel = new Panel(this);
    this.timeline = new Timeline(this);
    this.describe();
    this.makeControls();
    movePointers(byId("world"), this.camera, this, (px, py) =>
      this.choose(bodyAt(this.painter, this.camera.world(px, py), this.wholeStep(), 6 / this.camera.scale)));
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
    for (const [key, meaning] of KEYS) {
      const row = element("tr");
      row.append(element("td"), element("td", "", meaning));
      row.firstChild.append(element("kbd", "", key));
      byId("keys").append(row);
    }
    byId("fit").addEventListener("click", () => { this.camera.fit(); this.redraw(); });
    byId("theme").addEventListener("click", () => this.setTheme(otherTheme(this.painter.theme.name, this.run.theme)));
    byId("panel-button").addEventListener("click", () => this.togglePanel());
    document.addEventListener("pointerdown", (event) => {
      for (const popup of document.querySelectorAll("details[open]")) if (!popup.contains(event.target)) popup.open = false;
    });
  }

  makeOverlay(overlay) {
    const label = element("label"), box = element("input"), swatch = element("i", "swatch");
    const missing = this.lackOf(overlay);
    box.type = "checkbox";
    box.id = `overlay-${overlay.id}`;
    box.checked = this.on[overlay.id];
    box.disabled = missing !== "";
    box.addEventListener("change", () => { this.on[overlay.id] = box.checked; this.redraw(); });
    swatch.style.background = overlay.color ? `var(--${overlay.color})` : "transparent";
    label.append(box, swatch, element("span", "", overlay.text), element("kbd", "", overlay.key.toUpperCase()));
    label.classList.toggle("off", missing !== "");
    label.title = missing;
    byId("overlay-list").append(label);
  }

  // Why an overlay would show nothing; empty if it has something to show.
  lackOf(overlay) {
    if (overlay.needsContacts && byId("contacts").textContent === "") return "The replay was made without contacts.";
    return overlay.needsNotes && this.run.notes.length === 0 ? "The scene has no notes." : "";
  }

  setTheme(name) {
    applyTheme(name, [this.painter]);
    this.resize();
  }

  togglePanel(shown = byId("panel").hidden) {
    byId("panel").hidden = !shown;
    byId("panel-button").setAttribute("aria-expanded", String(shown));
    this.redraw();
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
    if (event.key === "Escape") {
      this.claim = null;
      this.say("");
      this.choose(-1);
      event.target.blur();
      return;
    }
    if (isForControl(event)) return;
    const actions = this.keyActions(this.camera, event.shiftKey ? 10 : 1);
    actions.f = () => { if (this.chosen >= 0) this.toggleFollow(); };
    actions["/"] = () => { this.togglePanel(true); this.panel.show("bodies"); byId("search").focus(); };
    const overlay = OVERLAYS.find((one) => one.key === event.key.toLowerCase());
    if (overlay && !byId(`overlay-${overlay.id}`).disabled) byId(`overlay-${overlay.id}`).click();
    else if (actions[event.key]) actions[event.key]();
    else return;
    event.preventDefault();
    this.redraw();
  }

  // Drawing.

  resize() {
    this.painter.resize();
    this.timeline.draw();
    this.redraw();
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
    this.painter.usePixels();
    if (this.on.notes) this.overlays.notes(this.step);
  }

  drawTexts() {
    const bar = roundLength(60 / this.camera.scale).metres;
    this.showClock();
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
  document.documentElement.dataset.theme = states.theme || systemTheme();
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

function fail(error) { showFailure("This replay cannot be shown", error); }

// For scripts: await replay.whole, then replay.player.seek(120), replay.player.run.pose(3, 120). `ready` comes before
// `whole`, without the contacts.
const ready = start().then((player) => (window.replay.player = player), fail);
window.replay = { player: null, ready, whole: ready.then(addContacts).catch(fail) };
