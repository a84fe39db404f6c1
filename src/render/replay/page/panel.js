// The panel: the chosen body with its values and a plot of one of them, and lists of bodies, claims and events.

const TYPES = ["static", "kinematic", "dynamic"];
const ROW = 30;  // px

const degrees = (radians) => radians / TURN * 360;
const QUANTITIES = [
  { id: "y", text: "y, m", of: (run, body, step) => run.pose(body, step).y },
  { id: "x", text: "x, m", of: (run, body, step) => run.pose(body, step).x },
  { id: "angle", text: "angle, degrees", of: (run, body, step) => degrees(run.pose(body, step).angle) },
  { id: "speed", text: "speed, m/s", of: (run, body, step) => { const v = run.velocity(body, step); return Math.hypot(v.x, v.y); } },
  { id: "vx", text: "velocity in x, m/s", of: (run, body, step) => run.velocity(body, step).x },
  { id: "vy", text: "velocity in y, m/s", of: (run, body, step) => run.velocity(body, step).y },
  { id: "spin", text: "angular velocity, degrees/s", of: (run, body, step) => degrees(run.velocity(body, step).angular) },
];

class Panel {
  constructor(player) {
    this.player = player;
    this.run = player.run;
    this.shown = this.run.bodies.map((_, number) => number);
    for (const quantity of QUANTITIES) byId("quantity").append(new Option(quantity.text, quantity.id));
    byId("quantity").addEventListener("change", () => { this.plotted = null; player.redraw(); });
    byId("follow").addEventListener("click", () => player.toggleFollow());
    byId("deselect").addEventListener("click", () => player.choose(-1));
    byId("search").addEventListener("input", () => this.search());
    byId("rows").addEventListener("scroll", () => this.rows());
    byId("rows").addEventListener("click", (event) => {
      const row = event.target.closest(".body");
      if (row) player.choose(Number(row.dataset.body), true);
    });
    for (const tab of document.querySelectorAll("#tabs button")) tab.addEventListener("click", () => this.show(tab.dataset.list));
    this.timePlot = new TimePlot(byId("plot"), this.run.last_step, (step) => player.seek(step));
    this.list("claims", this.run.claims, (claim) => this.claimItem(claim), "The scene makes no claims.");
    this.list("events", this.run.events, (event) => this.eventItem(event), "No events of a timeline, no broken joints.");
    const failed = this.run.claims.filter((claim) => !claim.passed).length;
    this.label("bodies", `Bodies ${this.run.bodies.length}`);
    this.label("claims", failed > 0 ? `Claims ${failed} \u2717` : `Claims ${this.run.claims.length}`);
    this.label("events", `Events ${this.run.events.length}`);
  }

  label(list, text) { document.querySelector(`#tabs [data-list=${list}]`).textContent = text; }

  show(list) {
    for (const tab of document.querySelectorAll("#tabs button")) {
      tab.setAttribute("aria-selected", String(tab.dataset.list === list));
      byId(tab.dataset.list).hidden = tab.dataset.list !== list;
    }
    this.rows();
  }

  list(id, entries, make, none) {
    byId(id).replaceChildren(...entries.map(make));
    if (entries.length === 0) byId(id).append(element("p", "none", none));
  }

  claimItem(claim) {
    const item = element("button", `item ${claim.passed ? "good" : "bad"}`);
    item.append(element("span", "when", this.player.timeText(claim.step)), element("span", "", claim.claim), element("span", "finding", claim.finding));
    item.addEventListener("click", () => this.player.showClaim(claim));
    claim.item = item;
    return item;
  }

  eventItem(event) {
    const item = element("button", "item");
    item.append(element("span", "when", this.player.timeText(event.step)), element("span", "", event.text));
    item.addEventListener("click", () => this.player.showEvent(event));
    return item;
  }

  search() {
    const wanted = byId("search").value.toLowerCase();
    this.shown = [...this.run.bodies.keys()].filter((number) => this.run.bodies[number].name.toLowerCase().includes(wanted));
    byId("rows").scrollTop = 0;
    this.rows();
  }

  // Only the rows in view exist.
  rows() {
    const view = byId("rows"), first = Math.floor(Math.max(0, view.scrollTop - ROW) / ROW), last = Math.ceil((view.scrollTop + view.clientHeight) / ROW);
    byId("spacer").style.height = `${this.shown.length * ROW}px`;
    byId("spacer").replaceChildren(...this.shown.slice(first, last).map((number, i) => this.row(number, (first + i) * ROW)));
  }

  row(number, top) {
    const step = this.player.wholeStep(), exists = this.run.exists(number, step), row = element("div", "row body");
    row.dataset.body = number;
    row.style.top = `${top}px`;
    row.classList.toggle("gone", !exists);
    row.classList.toggle("chosen", number === this.player.chosen);
    row.append(element("span", "", this.run.bodies[number].name));
    row.firstChild.title = this.run.bodies[number].name;
    for (const id of ["x", "y", "speed"])
      row.append(element("span", "", exists ? fixed(QUANTITIES.find((one) => one.id === id).of(this.run, number, step), 2) : "\u2013"));
    return row;
  }

  values() {
    const number = this.player.chosen, step = this.player.wholeStep();
    byId("selected").hidden = number < 0;
    if (number < 0) return;
    const body = this.run.bodies[number];
    byId("body-name").textContent = body.name;
    byId("follow").setAttribute("aria-pressed", String(this.player.camera.following === number));
    const entries = this.run.exists(number, step) ? this.entries(number, step) : [["state", step < body.from ? "does not exist yet" : "removed"]];
    byId("values").replaceChildren(...entries.flatMap(([name, text]) => [element("dt", "", name), element("dd", "", text)]));
    this.plot(number, step);
  }

  entries(number, step) {
    const body = this.run.bodies[number], pose = this.run.pose(number, step), v = this.run.velocity(number, step);
    const asleep = body.type === 2 ? (this.run.isAsleep(number, step) ? ", asleep" : ", awake") : "";
    const entries = [["type", TYPES[body.type] + asleep], ["position", `${fixed(pose.x)}, ${fixed(pose.y)} m`],
                     ["angle", `${fixed(degrees(pose.angle), 1)}\u00b0`]];
    if (body.type !== 0)
      entries.push(["velocity", `${fixed(v.x, 2)}, ${fixed(v.y, 2)} m/s`], ["speed", `${fixed(Math.hypot(v.x, v.y), 2)} m/s`],
                   ["angular velocity", `${fixed(degrees(v.angular), 0)}\u00b0/s`]);
    if (body.type === 2) entries.push(["mass", `${Number(body.mass.toPrecision(4))} kg`]);
    if (this.run.contacts) entries.push(["touches", this.touched(number, step)]);
    return entries;
  }

  touched(number, step) {
    const names = new Set();
    this.run.eachContact(step, (a, b, x, y, nx, ny, impulse) => {
      if (impulse === 0) return;  // near, but not pressed together
      if (a === number || b === number) names.add(this.run.bodies[a === number ? b : a].name);
    });
    const most = 4, list = [...names];
    return list.length === 0 ? "nothing" : list.slice(0, most).join(", ") + (list.length > most ? ` and ${list.length - most} more` : "");
  }

  // The values of the chosen quantity at the steps in which a body exists.
  series(number) {
    const quantity = QUANTITIES.find((one) => one.id === byId("quantity").value), body = this.run.bodies[number];
    if (this.plotted?.number !== number || this.plotted.quantity !== quantity)
      this.plotted = { number, quantity, from: body.from, values: Float64Array.from({ length: body.count }, (_, i) => quantity.of(this.run, number, body.from + i)) };
    return this.plotted;
  }

  plot(number, step) {
    const theme = this.player.painter.theme;
    this.timePlot.draw(theme, [{ ...this.series(number), color: theme.accent }], step);
  }
}
