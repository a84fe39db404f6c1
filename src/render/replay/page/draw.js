// Draws the bodies and the grid on the canvas.

function cssColor(name) { return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim(); }

function channels(hex) { return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)); }

function mix(a, b, share) {
  const to = channels(b);
  return "#" + channels(a).map((value, i) => Math.round(value + share * (to[i] - value)).toString(16).padStart(2, "0")).join("");
}

// The colours of the theme, and of bodies in it.
class Theme {
  constructor() {
    this.name = document.documentElement.dataset.theme;
    this.outlineShare = Number(cssColor("outline-share"));
    for (const name of ["ground", "text", "faint", "minor", "major", "ink", "accent", "good", "bad", "event", "contact", "normal",
                        "box", "velocity", "joint", "trail", "anchor", "rule"]) this[name] = cssColor(name);
    this.known = new Map();
  }

  paint(fill, isStatic, isAsleep) {
    const key = fill + isStatic + isAsleep;
    if (!this.known.has(key)) {
      let inside = this.name === "dark" ? mix(fill, this.ground, isStatic ? 0.66 : 0.12) : fill;
      if (isAsleep) inside = mix(inside, this.ground, 0.55);
      this.known.set(key, { fill: inside, line: mix(inside, this.ink, this.outlineShare) });
    }
    return this.known.get(key);
  }
}

function systemTheme() { return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"; }

function isDark(theme) { return theme === "dark" || theme === "high_contrast"; }

// What the button switches to: from dark to light colours or back, and to those that the run states, if it does.
function otherTheme(name, stated) {
  if (stated !== "" && isDark(stated) !== isDark(name)) return stated;
  return isDark(name) ? "light" : "dark";
}

function applyTheme(name, painters) {
  document.documentElement.dataset.theme = name;
  for (const painter of painters) painter.theme = new Theme();
  byId("theme").textContent = isDark(name) ? "Light" : "Dark";
}

// The outline of the convex hull of a shape's points grown by its radius, as a path in body coordinates.
function pathOf(shape) {
  const path = new Path2D(), p = shape.points, n = p.length / 2, r = shape.radius;
  if (n === 1) {
    path.arc(p[0], p[1], r, 0, TURN);
    return path;
  }
  if (n === 2 && r === 0) {
    path.moveTo(p[0], p[1]);
    path.lineTo(p[2], p[3]);
    return path;
  }
  for (let i = 0; i < n; i++) {
    const [x, y, nextX, nextY] = [p[2 * i], p[2 * i + 1], p[2 * ((i + 1) % n)], p[2 * ((i + 1) % n) + 1]];
    if (r === 0) {
      path.lineTo(x, y);
      continue;
    }
    const previous = (i + n - 1) % n;
    const before = Math.atan2(y - p[2 * previous + 1], x - p[2 * previous]), after = Math.atan2(nextY - y, nextX - x);
    path.arc(x, y, r, before - TURN / 4, after - TURN / 4);
  }
  path.closePath();
  return path;
}

function addShapeData(shape) {
  shape.path = pathOf(shape);
  shape.isLine = shape.points.length === 4 && shape.radius === 0;
  shape.reach = 0;
  for (let i = 0; i < shape.points.length; i += 2)
    shape.reach = Math.max(shape.reach, Math.hypot(shape.points[i], shape.points[i + 1]) + shape.radius);
}

class Painter {
  constructor(canvas, run, camera) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d", { alpha: false });
    this.run = run;
    this.camera = camera;
    this.theme = new Theme();
    run.shapes.forEach(addShapeData);
    for (const body of run.bodies) body.reach = Math.max(0, ...body.shapes.map(([shape]) => run.shapes[shape].reach));
    const numbers = [...run.bodies.keys()];
    this.still = numbers.filter((number) => run.bodies[number].type === 0);  // behind all others
    this.moving = numbers.filter((number) => run.bodies[number].type !== 0);
  }

  resize() {
    const ratio = window.devicePixelRatio || 1, { clientWidth, clientHeight } = this.canvas;
    this.canvas.width = Math.max(1, Math.round(clientWidth * ratio));
    this.canvas.height = Math.max(1, Math.round(clientHeight * ratio));
    this.ratio = ratio;
    this.camera.resize(Math.max(1, clientWidth), Math.max(1, clientHeight));
  }

  // Coordinates of the context become CSS pixels.
  usePixels() { this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0); }

  // Coordinates of the context become those of a body, m, y up.
  useBody(pose) {
    const [px, py] = this.camera.pixels(pose.x, pose.y), scale = this.camera.scale * this.ratio;
    const c = Math.cos(pose.angle) * scale, s = Math.sin(pose.angle) * scale;
    this.context.setTransform(c, -s, -s, -c, px * this.ratio, py * this.ratio);
  }

  isInView(pose, reach) {
    const [px, py] = this.camera.pixels(pose.x, pose.y), r = reach * this.camera.scale + 2;
    return px > -r && py > -r && px < this.camera.width + r && py < this.camera.height + r;
  }

  clear() {
    this.usePixels();
    this.context.fillStyle = this.theme.ground;
    this.context.fillRect(0, 0, this.camera.width, this.camera.height);
  }

  grid() {
    const spacing = roundLength(28 / this.camera.scale), lines = [[], []];
    const [left, top] = this.camera.world(0, 0), [right, bottom] = this.camera.world(this.camera.width, this.camera.height);
    const every = spacing.mantissa === 5 ? 4 : 5;
    for (let i = Math.ceil(left / spacing.metres); i * spacing.metres <= right; i++)
      lines[i % every === 0 ? 1 : 0].push([this.camera.pixels(i * spacing.metres, 0)[0], -1]);
    for (let i = Math.ceil(bottom / spacing.metres); i * spacing.metres <= top; i++)
      lines[i % every === 0 ? 1 : 0].push([-1, this.camera.pixels(0, i * spacing.metres)[1]]);
    this.usePixels();
    lines.forEach((some, strong) => {
      this.context.fillStyle = strong ? this.theme.major : this.theme.minor;
      for (const [x, y] of some)
        if (y < 0) this.context.fillRect(Math.round(x), 0, 1, this.camera.height);
        else this.context.fillRect(0, Math.round(y), this.camera.width, 1);
    });
  }

  // `islands` is empty or the island of each body.
  bodies(step, islands, dimSleeping) {
    const whole = Math.floor(step), colors = this.run.island_colors;
    this.eachInView(this.still, step, (body) => this.shapes(body, null, false));
    if (this.run.hatching) this.hatching(step);
    this.eachInView(this.moving, step, (body, number) => {
      const asleep = dimSleeping && body.asleep.length > 0 && this.run.isAsleep(number, whole);
      const color = islands.length > 0 && body.type === 2 ? colors[islands[number] % colors.length] : null;
      this.shapes(body, color, asleep);
      this.orientation(body);
    });
  }

  // Calls visit(body, number) in the coordinates of each of these bodies that is in view.
  eachInView(numbers, step, visit) {
    const whole = Math.floor(step);
    for (const number of numbers) {
      if (!this.run.exists(number, whole)) continue;
      const body = this.run.bodies[number], pose = this.run.pose(number, step);
      if (!this.isInView(pose, body.reach)) continue;
      this.useBody(pose);
      visit(body, number);
    }
  }

  shapes(body, color, asleep) {
    for (const [shape, fill, isSensor] of body.shapes)
      this.shape(this.run.shapes[shape], this.theme.paint(color ?? fill, body.type === 0, asleep), isSensor);
  }

  // As in frames: lines from the lower left to the upper right over the areas of static bodies, in the colours of their
  // outlines. They stay with the world when the view moves, and continue from one shape to the next.
  hatching(step) {
    const areas = new Map(), context = this.context;  // a path of the pixels of each colour
    this.eachInView(this.still, step, (body) => {
      for (const [number, fill, isSensor] of body.shapes) {
        const shape = this.run.shapes[number], color = this.theme.paint(fill, true, false).line;
        if (isSensor || shape.isLine) continue;
        if (!areas.has(color)) areas.set(color, new Path2D());
        areas.get(color).addPath(shape.path, context.getTransform());
      }
    });
    const lines = this.hatchLines();
    for (const [color, area] of areas) {
      context.save();
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.clip(area);
      this.usePixels();
      context.strokeStyle = color;
      context.globalAlpha = 0.45;
      context.lineWidth = 1;
      context.stroke(lines);
      context.restore();
    }
  }

  // All lines in the canvas, 12 pixels apart; one of them goes through the origin of the world.
  hatchLines() {
    const { width, height } = this.camera, [px, py] = this.camera.pixels(0, 0), spacing = 12 * Math.SQRT2, lines = new Path2D();
    const rest = (px + py) % spacing;
    for (let sum = rest - spacing; sum < width + height + spacing; sum += spacing) {  // px + py of a line's points
      lines.moveTo(sum, 0);
      lines.lineTo(sum - height, height);
    }
    return lines;
  }

  shape(shape, paint, isSensor) {
    const context = this.context, pixel = 1 / this.camera.scale;
    context.fillStyle = paint.fill;
    context.strokeStyle = paint.line;
    context.lineWidth = (shape.isLine ? 2.5 : 1.4) * pixel;
    if (isSensor) {
      context.globalAlpha = 0.3;
      context.fill(shape.path);
      context.globalAlpha = 1;
      // A sensor far larger than the canvas has a line without dashes: each dash takes time, also out of view.
      const mostReach = 10000;  // pixels
      if (shape.reach < mostReach * pixel) context.setLineDash([6 * pixel, 5 * pixel]);
      context.stroke(shape.path);
      context.setLineDash([]);
      return;
    }
    if (!shape.isLine) context.fill(shape.path);
    context.stroke(shape.path);
  }

  // A radius in each circle shows the angle.
  orientation(body) {
    for (const [number, , isSensor] of body.shapes) {
      const shape = this.run.shapes[number];
      if (isSensor || shape.points.length > 2 || shape.radius * this.camera.scale < 5) continue;
      this.context.globalAlpha = 0.6;
      this.context.beginPath();
      this.context.moveTo(shape.points[0], shape.points[1]);
      this.context.lineTo(shape.points[0] + shape.radius, shape.points[1]);
      this.context.stroke();
      this.context.globalAlpha = 1;
    }
  }

  outline(number, step, color, width) {
    if (!this.run.exists(number, Math.floor(step))) return;
    this.useBody(this.run.pose(number, step));
    this.context.strokeStyle = color;
    this.context.lineWidth = width / this.camera.scale;
    for (const [shape] of this.run.bodies[number].shapes) this.context.stroke(this.run.shapes[shape].path);
  }
}

// The smallest 1, 2 or 5 times a power of ten of at least `metres`.
function roundLength(metres) {
  const power = 10 ** Math.floor(Math.log10(metres));
  for (const mantissa of [1, 2, 5]) if (mantissa * power >= metres * (1 - 1e-9)) return { mantissa, metres: mantissa * power };
  return { mantissa: 1, metres: 10 * power };
}

// The number of the body at a world point, within `tolerance` m; -1 for none. The one drawn last counts.
function bodyAt(painter, point, step, tolerance) {
  const run = painter.run;
  let found = -1, foundDistance = tolerance;
  for (const number of [...painter.still, ...painter.moving]) {
    if (!run.exists(number, step)) continue;
    const pose = run.pose(number, step), body = run.bodies[number];
    if (Math.hypot(point[0] - pose.x, point[1] - pose.y) > body.reach + tolerance) continue;
    const local = localPoint(pose, point);
    for (const [shape] of body.shapes) {
      const distance = Math.max(0, distanceTo(run.shapes[shape], local));
      if (distance <= foundDistance) [found, foundDistance] = [number, distance];
    }
  }
  return found;
}

// Signed: negative inside.
function distanceTo(shape, [x, y]) {
  const p = shape.points, n = p.length / 2;
  let nearest = Infinity, inside = n >= 3;
  for (let i = 0; i < n; i++) {
    const j = (i + 1) % n, dx = p[2 * j] - p[2 * i], dy = p[2 * j + 1] - p[2 * i + 1], rx = x - p[2 * i], ry = y - p[2 * i + 1];
    const along = Math.min(1, Math.max(0, (rx * dx + ry * dy) / (dx * dx + dy * dy || 1)));
    nearest = Math.min(nearest, Math.hypot(rx - along * dx, ry - along * dy));
    if (dx * ry - dy * rx < 0) inside = false;
  }
  return (inside ? -nearest : nearest) - shape.radius;
}
