// A plot of values over the steps of a run, in which a click or a drag seeks.

class TimePlot {
  constructor(canvas, lastStep, seek) {
    this.canvas = canvas;
    this.lastStep = lastStep;
    const seekAt = (event) => {
      const box = canvas.getBoundingClientRect();
      seek((event.clientX - box.left) / box.width * lastStep);
    };
    canvas.addEventListener("pointerdown", seekAt);
    canvas.addEventListener("pointermove", (event) => { if (event.buttons) seekAt(event); });
  }

  // Curves are {values, from, color}: values[i] is that of the step from + i, null where it is not known. The first has
  // a dot at the step. `marked` is a step with a dashed line, or null.
  draw(theme, curves, step, marked = null) {
    const context = this.context(), width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    this.scale(curves, width, height);
    context.strokeStyle = theme.rule;
    context.strokeRect(0.5, 0.5, width - 1, height - 1);
    if (marked !== null) this.dashed(context, theme.bad, this.toX(marked));
    context.lineWidth = 1.5;
    curves.forEach((curve, i) => {
      context.strokeStyle = curve.color;
      context.stroke(this.paths[i]);
    });
    context.fillStyle = theme.faint;
    context.fillRect(Math.round(this.toX(step)), 0, 1, height);
    context.font = "11px system-ui, sans-serif";
    context.fillText(brief(this.high), 4, 12);
    context.fillText(brief(this.low), 4, height - 4);
    const value = curves[0].values[step - curves[0].from];
    if (typeof value !== "number") return;
    context.beginPath();
    context.arc(this.toX(step), this.toY(value), 3.5, 0, TURN);
    context.fillStyle = curves[0].color;
    context.fill();
  }

  context() {
    const ratio = window.devicePixelRatio || 1, context = this.canvas.getContext("2d");
    this.canvas.width = this.canvas.clientWidth * ratio;
    this.canvas.height = this.canvas.clientHeight * ratio;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    return context;
  }

  dashed(context, color, x) {
    context.strokeStyle = color;
    context.setLineDash([4, 3]);
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x, this.canvas.clientHeight);
    context.stroke();
    context.setLineDash([]);
  }

  toX(step) { return step / Math.max(1, this.lastStep) * this.width; }

  toY(value) {
    const pad = 16;
    return this.high > this.low ? this.height - pad - (value - this.low) / (this.high - this.low) * (this.height - 2 * pad) : this.height / 2;
  }

  // The range and the paths are kept while the values and the size are the same.
  scale(curves, width, height) {
    const known = this.paths && this.width === width && this.height === height && curves.every((curve, i) => curve.values === this.values[i]);
    if (known) return;
    [this.width, this.height] = [width, height];
    this.values = curves.map((curve) => curve.values);
    [this.low, this.high] = [Infinity, -Infinity];
    for (const values of this.values)
      for (const value of values) if (value !== null) [this.low, this.high] = [Math.min(this.low, value), Math.max(this.high, value)];
    if (this.low > this.high) [this.low, this.high] = [0, 0];
    this.paths = curves.map((curve) => this.pathOf(curve));
  }

  pathOf({ values, from }) {
    const path = new Path2D();
    values.forEach((value, i) => { if (value !== null) path.lineTo(this.toX(from + i), this.toY(value)); });
    return path;
  }
}

// Two digits after the point, or four significant ones of a number below 1.
function brief(value) { return Math.abs(value) < 1 && value !== 0 ? String(Number(value.toPrecision(4))) : fixed(value, 2); }
