// What is asked of the states: poses, velocities, contacts at a step. Positions in m, angles in rad.

const TURN = 2 * Math.PI;

class Run {
  constructor(states, contacts) {
    Object.assign(this, states);
    this.contacts = contacts;
    // The bodies of the name that a note is above; at most one of them exists at a time.
    for (const note of this.notes) note.bodies = [...this.bodies.keys()].filter((number) => this.bodies[number].name === note.above);
  }

  exists(number, step) {
    const body = this.bodies[number];
    return step >= body.from && step < body.from + body.count;
  }

  // The pose at a step; between two steps on the straight line between theirs.
  pose(number, step) {
    const body = this.bodies[number], whole = Math.floor(step), part = step - whole;
    const i = body.first + whole - body.from;
    const j = part > 0 && whole + 1 < body.from + body.count ? i + 1 : i;
    const between = (sequence) => sequence[i] + part * (sequence[j] - sequence[i]);
    return { x: body.base[0] + this.quantum * between(this.x), y: body.base[1] + this.quantum * between(this.y),
             angle: between(this.angle) / this.angles_per_turn * TURN };
  }

  center(number, step) {
    const pose = this.pose(number, step);
    return worldPoint(pose, this.bodies[number].center);
  }

  // The point that a note is above at a step: its own, or the top of its body; null when the note is not shown.
  notePoint({ from, until, position, bodies }, step) {
    const time = step / this.steps_per_second, whole = Math.floor(step);
    if (time < from || time >= (until ?? Infinity)) return null;
    if (position) return position;
    const number = bodies.find((one) => this.exists(one, whole)) ?? -1;
    if (number < 0 || this.bodies[number].shapes.length === 0) return null;
    const pose = this.pose(number, step), boxes = this.bodies[number].shapes.map(([shape]) => boundsOf(this.shapes[shape], pose));
    const left = Math.min(...boxes.map((box) => box[0])), right = Math.max(...boxes.map((box) => box[2]));
    return [(left + right) / 2, Math.max(...boxes.map((box) => box[3]))];
  }

  // What the frame of a step shows: its center and its height, m, and whether it follows a body.
  frame(step) {
    const whole = Math.floor(step), [, follows, x, y, height] = this.views.findLast(([from]) => from <= whole);
    if (follows < 0) return { center: [x, y], height, follows: false };
    const pose = this.pose(follows, step);
    return { center: [pose.x + x, pose.y + y], height, follows: true };
  }

  // From the step before, or at the first step to the one after: the quantum of positions times the steps per second
  // is its resolution.
  velocity(number, step) {
    const body = this.bodies[number];
    const to = Math.max(Math.floor(step), Math.min(body.from + 1, body.from + body.count - 1));
    const from = Math.max(to - 1, body.from), i = body.first - body.from;
    const a = this.center(number, from), b = this.center(number, to), rate = this.steps_per_second;
    const turned = (this.angle[i + to] - this.angle[i + from]) / this.angles_per_turn * TURN;
    return { x: (b[0] - a[0]) * rate, y: (b[1] - a[1]) * rate, angular: turned * rate };
  }

  isAsleep(number, step) {
    let asleep = false;
    for (const toggle of this.bodies[number].asleep) if (toggle <= step) asleep = !asleep;
    return asleep;
  }

  // Calls visit(a, b, x, y, normal x, normal y, impulse) for each contact point of a step.
  eachContact(step, visit) {
    const tracks = this.contacts;
    if (!tracks) return;
    const [xs, ys, normals, impulses] = tracks.points;
    for (const i of tracks.inPart[Math.floor(step / STEPS_PER_PART)] ?? []) {
      if (step < tracks.from[i] || step >= tracks.from[i] + tracks.count[i]) continue;
      const k = tracks.first[i] + step - tracks.from[i];
      const pose = this.pose(tracks.a[i], step);
      const at = worldPoint(pose, [xs[k] * this.contact_quantum, ys[k] * this.contact_quantum]);
      const angle = pose.angle + normals[k] / this.normals_per_turn * TURN;
      const impulse = impulses[k] === 0 ? 0 : this.least_impulse * 2 ** ((impulses[k] - 1) / this.impulses_per_octave);
      visit(tracks.a[i], tracks.b[i], at[0], at[1], Math.cos(angle), Math.sin(angle), impulse);
    }
  }

  // For each dynamic body the lowest number in its island: of the bodies that have contact points with it, or are
  // joined to it. The world's own islands may differ.
  islands(step) {
    const root = Int32Array.from(this.bodies, (_, i) => i);
    const find = (i) => { while (root[i] !== i) i = root[i] = root[root[i]]; return i; };
    const join = (a, b) => {
      if (this.bodies[a].type !== 2 || this.bodies[b].type !== 2) return;
      const [low, high] = [find(a), find(b)].sort((p, q) => p - q);
      root[high] = low;
    };
    this.eachContact(step, join);
    for (const joint of this.joints) if (spanAt(joint, step)) join(joint.a, joint.b);
    return root.map((_, i) => find(i));
  }
}

function worldPoint(pose, local) {
  const c = Math.cos(pose.angle), s = Math.sin(pose.angle);
  return [pose.x + c * local[0] - s * local[1], pose.y + s * local[0] + c * local[1]];
}

function localPoint(pose, world) {
  const c = Math.cos(pose.angle), s = Math.sin(pose.angle), x = world[0] - pose.x, y = world[1] - pose.y;
  return [c * x + s * y, c * y - s * x];
}

function spanAt(joint, step) {
  return joint.spans.find((span) => step >= span[0] && step < span[1]);
}

// The part of the world in the canvas. Pixels are those of CSS, y down.
//
// `asFrames` shows what the frame of the step shows, which may follow a body of the scene's choice. A user who moves the
// view ends that, and may follow another body, `following`, in the middle.
class Camera {
  constructor(run) {
    this.run = run;
    this.x = 0;
    this.y = 0;
    this.scale = 1;
    this.width = 1;
    this.height = 1;
    this.fit();
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
  }

  // The first view, with the whole frame in the canvas.
  fit() {
    this.asFrames = true;
    this.magnified = 1;  // by a user who zooms while the frame follows a body
    this.following = -1;
  }

  follow(number) {
    this.asFrames = false;
    this.following = number;
  }

  moveTo(x, y) {
    this.asFrames = false;
    [this.x, this.y] = [x, y];
  }

  // To be called before a step is drawn.
  show(step) {
    if (this.asFrames) {
      const frame = this.run.frame(step);
      [this.x, this.y] = frame.center;
      this.scale = this.magnified * Math.min(this.height / frame.height, this.width / (frame.height * this.run.aspect_ratio));
    } else if (this.following >= 0 && this.run.exists(this.following, Math.floor(step)))
      ({ x: this.x, y: this.y } = this.run.pose(this.following, step));
  }

  pixels(x, y) { return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale]; }
  world(px, py) { return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale]; }

  zoom(factor, step, px = this.width / 2, py = this.height / 2) {
    const [x, y] = this.world(px, py);
    const least = 1e-6, most = 1e6;  // pixels per metre
    const scale = Math.min(most, Math.max(least, this.scale * factor));
    this.magnified *= scale / this.scale;
    this.scale = scale;
    if (this.asFrames && !this.run.frame(step).follows) this.asFrames = false;
    const [movedX, movedY] = this.world(px, py);
    this.x += x - movedX;
    this.y += y - movedY;
  }

  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    this.asFrames = false;
    this.following = -1;
  }
}
