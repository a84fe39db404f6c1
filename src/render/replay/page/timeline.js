// The marks above the scrubber: events as ticks, claims as triangles in green or red.

const THUMB = 16;  // px: the scrubber's range is that much narrower than its box

class Timeline {
  constructor(player) {
    this.player = player;
    this.run = player.run;
    this.canvas = byId("marks");
    // Claims that fail are drawn last, over those that hold, and are found first.
    this.claims = [...this.run.claims].sort((a, b) => b.passed - a.passed);
    this.marks = [...this.run.events, ...this.claims];
    this.canvas.addEventListener("click", (event) => this.click(event));
    this.canvas.addEventListener("pointermove", (event) => {
      const mark = this.nearest(event);
      this.canvas.title = mark ? `${player.timeText(mark.step)}: ${mark.text ?? `${mark.passed ? "holds" : "fails"}: ${mark.claim}`}` : "";
    });
  }

  x(step) { return THUMB / 2 + step / Math.max(1, this.run.last_step) * (this.canvas.clientWidth - THUMB); }

  draw() {
    const ratio = window.devicePixelRatio || 1, theme = this.player.painter.theme, context = this.canvas.getContext("2d");
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = theme.event;
    for (const event of this.run.events) context.fillRect(Math.round(this.x(event.step)) - 1, 5, 2, height - 6);
    for (const claim of this.claims) {
      const x = this.x(claim.step);
      context.fillStyle = claim.passed ? theme.good : theme.bad;
      context.beginPath();
      context.moveTo(x - 6, 2);
      context.lineTo(x + 6, 2);
      context.lineTo(x, height - 2);
      context.fill();
    }
  }

  nearest(event) {
    const x = event.clientX - this.canvas.getBoundingClientRect().left, reach = 10;
    let found = null, distance = reach;
    for (const mark of this.marks)
      if (Math.abs(this.x(mark.step) - x) <= distance) [found, distance] = [mark, Math.abs(this.x(mark.step) - x)];
    return found;
  }

  click(event) {
    const mark = this.nearest(event);
    if (mark?.claim !== undefined) this.player.showClaim(mark);
    else if (mark) this.player.showEvent(mark);
  }
}
