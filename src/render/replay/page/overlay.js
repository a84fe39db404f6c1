// What can be drawn over the bodies.

const OVERLAYS = [
  { id: "contacts", key: "c", text: "Contacts, by impulse", color: "contact", needsContacts: true },
  { id: "normals", key: "n", text: "Contact normals", color: "normal", needsContacts: true },
  { id: "boxes", key: "b", text: "Bounding boxes", color: "box" },
  { id: "joints", key: "j", text: "Joints", color: "joint", on: true },
  { id: "velocities", key: "v", text: "Velocities, as far as in 0.1 s", color: "velocity" },
  { id: "trails", key: "t", text: "Trails of the last 2 s", color: "trail" },
  { id: "islands", key: "i", text: "Islands, a colour each", needsContacts: true },
  { id: "notes", key: "o", text: "Notes of the scene", needsNotes: true, on: true },
  { id: "sleeping", key: "s", text: "Sleeping bodies dimmed", on: true },
];

class OverlayPainter {
  constructor(painter) {
    this.painter = painter;
    this.context = painter.context;
    this.camera = painter.camera;
    this.run = painter.run;
  }

  // Dots are [x, y, radius in pixels]; all are one path.
  dots(some, fill) {
    this.context.beginPath();
    for (const [x, y, radius] of some) {
      const [px, py] = this.camera.pixels(x, y);
      this.context.moveTo(px + radius, py);
      this.context.arc(px, py, radius, 0, TURN);
    }
    this.context.fillStyle = fill;
    this.context.fill();
  }

  line(points, color, width) {
    this.context.beginPath();
    for (const [x, y] of points) this.context.lineTo(...this.camera.pixels(x, y));
    this.context.strokeStyle = color;
    this.context.lineWidth = width;
    this.context.stroke();
  }

  // Only the part in view: a region may be thousands of frames wide, and each dash takes time.
  dashedLine(from, to, color, width) {
    const part = clipped(this.camera.pixels(...from), this.camera.pixels(...to), this.camera.width, this.camera.height);
    if (part) this.line(part.map(([px, py]) => this.camera.world(px, py)), color, width);
  }

  // Arrows are [x, y, dx, dy]: from a world point, dx and dy in pixels, y up. All are one path.
  arrows(some, color) {
    const lines = new Path2D(), heads = new Path2D();
    for (const [x, y, dx, dy] of some) {
      const length = Math.hypot(dx, dy);
      if (length < 2) continue;
      const [px, py] = this.camera.pixels(x, y), ex = px + dx, ey = py - dy, head = Math.min(7, length / 2);
      const ux = dx / length * head, uy = -dy / length * head;
      lines.moveTo(px, py);
      lines.lineTo(ex - ux * 0.8, ey - uy * 0.8);
      heads.moveTo(ex, ey);
      heads.lineTo(ex - ux - uy / 2, ey - uy + ux / 2);
      heads.lineTo(ex - ux + uy / 2, ey - uy - ux / 2);
    }
    this.context.strokeStyle = this.context.fillStyle = color;
    this.context.lineWidth = 1.8;
    this.context.stroke(lines);
    this.context.fill(heads);
  }

  joints(step) {
    const whole = Math.floor(step), theme = this.painter.theme;
    const anchors = [];
    for (const joint of this.run.joints) {
      const span = spanAt(joint, whole);
      if (!span || !this.run.exists(joint.a, whole) || !this.run.exists(joint.b, whole)) continue;
      const points = [worldPoint(this.run.pose(joint.a, step), span.slice(2, 4))];
      for (let i = 0; i < joint.wheels.length; i += 2) points.push(joint.wheels.slice(i, i + 2));
      points.push(worldPoint(this.run.pose(joint.b, step), span.slice(4, 6)));
      this.line(points, theme.joint, 1.5);
      const radius = Math.min(3.2, 0.12 * this.camera.scale);
      if (radius > 0.8) anchors.push(...points.map(([x, y]) => [x, y, radius]));
    }
    this.dots(anchors, theme.joint);
    this.dots(anchors.map(([x, y, radius]) => [x, y, radius - 1.2]), theme.anchor);
  }

  contacts(step, on) {
    const dots = [], normals = [], shown = ([px, py]) => px > -30 && py > -30 && px < this.camera.width + 30 && py < this.camera.height + 30;
    this.run.eachContact(Math.floor(step), (a, b, x, y, nx, ny, impulse) => {
      if (!shown(this.camera.pixels(x, y))) return;
      dots.push([x, y, this.dotRadius(impulse)]);
      normals.push([x, y, 20 * nx, 20 * ny]);
    });
    if (on.normals) this.arrows(normals, this.painter.theme.normal);
    if (on.contacts) this.dots(dots, this.painter.theme.contact);
  }

  // The area grows with the impulse; the largest of the run has a radius of 11 pixels.
  dotRadius(impulse) {
    if (this.largestImpulse === undefined) {
      const code = this.run.contacts.points[3].reduce((most, value) => Math.max(most, value), 0);
      this.largestImpulse = this.run.least_impulse * 2 ** ((code - 1) / this.run.impulses_per_octave);
    }
    return 2 + 9 * Math.sqrt(Math.min(1, impulse / this.largestImpulse));
  }

  boxes(step) {
    this.context.strokeStyle = this.painter.theme.box;
    this.context.lineWidth = 1;
    this.run.bodies.forEach((body, number) => {
      if (!this.run.exists(number, Math.floor(step))) return;
      const pose = this.run.pose(number, step);
      for (const [shape] of body.shapes) {
        const [left, bottom, right, top] = boundsOf(this.run.shapes[shape], pose);
        const [px, py] = this.camera.pixels(left, top);
        this.context.strokeRect(px, py, (right - left) * this.camera.scale, (top - bottom) * this.camera.scale);
      }
    });
  }

  velocities(step) {
    const scale = 0.1 * this.camera.scale, arrows = [];
    this.run.bodies.forEach((body, number) => {
      if (body.type === 0 || !this.run.exists(number, Math.floor(step))) return;
      const v = this.run.velocity(number, step);
      arrows.push([...this.run.center(number, step), v.x * scale, v.y * scale]);
    });
    this.arrows(arrows, this.painter.theme.velocity);
  }

  // Of the chosen body, or of all that are not static.
  trails(step, chosen) {
    const whole = Math.floor(step), steps = Math.round(2 * this.run.steps_per_second);
    this.run.bodies.forEach((body, number) => {
      if (body.type === 0 || (chosen >= 0 && number !== chosen) || !this.run.exists(number, whole)) return;
      const points = [];
      for (let k = Math.max(body.from, whole - steps); k <= whole; k++) points.push(this.run.center(number, k));
      this.line(points, this.painter.theme.trail, chosen >= 0 ? 2 : 1);
    });
  }

  // As in frames, a note is above its point, and is moved into the canvas at its edge.
  notes(step) {
    for (const note of this.run.notes) {
      const point = this.run.notePoint(note, step), [px, py] = point ? this.camera.pixels(...point) : [-1, -1];
      if (px >= 0 && py >= 0 && px <= this.camera.width && py <= this.camera.height) this.plate(note.text, px, py - 7);
    }
  }

  // A line that is too wide is cut and ends with an ellipsis.
  fitted(line, room) {
    if (this.context.measureText(line).width <= room) return line;
    const letters = Array.from(line);
    while (letters.length > 0 && this.context.measureText(letters.join("") + "\u2026").width > room) letters.pop();
    return letters.join("") + "\u2026";
  }

  plate(text, middle, bottom) {
    const context = this.context, height = 18, pad = 5, edge = 6;
    context.font = '14px system-ui, "DejaVu Sans", Verdana, sans-serif';
    const room = this.camera.width - 2 * (edge + pad);
    const lines = text.split("\n").slice(0, 40).map((line) => this.fitted(line, room));
    const wide = Math.max(...lines.map((line) => context.measureText(line).width)) + 2 * pad, high = lines.length * height + 2 * pad;
    const left = Math.max(edge, Math.min(middle - wide / 2, this.camera.width - edge - wide));
    const top = Math.max(edge, Math.min(bottom - high, this.camera.height - edge - high));
    context.globalAlpha = 0.82;
    context.fillStyle = this.painter.theme.ground;
    context.fillRect(left, top, wide, high);
    context.globalAlpha = 1;
    context.fillStyle = this.painter.theme.text;
    context.textAlign = "center";
    context.textBaseline = "middle";
    lines.forEach((line, i) => context.fillText(line, left + wide / 2, top + pad + (i + 0.5) * height));
  }

  claim(claim, step) {
    const color = claim.passed ? this.painter.theme.good : this.painter.theme.bad;
    for (const body of claim.bodies) this.painter.outline(body, step, color, 3);
    this.painter.usePixels();
    this.context.setLineDash([8, 5]);
    for (const r of claim.regions)
      for (const [i, j] of [[0, 2], [2, 4], [4, 6], [6, 0]]) this.dashedLine([r[i], r[i + 1]], [r[j], r[j + 1]], color, 2.5);
    this.context.setLineDash([]);
  }
}

// The part of a line between two pixels that is in the canvas or up to 10 pixels beside it; null if there is none. By
// Liang and Barsky.
function clipped(from, to, width, height) {
  const margin = 10;
  let first = 0, last = 1;
  for (const [axis, most] of [[0, width], [1, height]]) {
    const length = to[axis] - from[axis], low = -margin - from[axis], high = most + margin - from[axis];
    if (length === 0 && (low > 0 || high < 0)) return null;
    if (length === 0) continue;
    first = Math.max(first, Math.min(low / length, high / length));
    last = Math.min(last, Math.max(low / length, high / length));
  }
  const at = (share) => [0, 1].map((axis) => from[axis] + share * (to[axis] - from[axis]));
  return first <= last ? [at(first), at(last)] : null;
}

function boundsOf(shape, pose) {
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < shape.points.length; i += 2) {
    const [x, y] = worldPoint(pose, [shape.points[i], shape.points[i + 1]]);
    left = Math.min(left, x - shape.radius);
    right = Math.max(right, x + shape.radius);
    bottom = Math.min(bottom, y - shape.radius);
    top = Math.max(top, y + shape.radius);
  }
  return [left, bottom, right, top];
}
