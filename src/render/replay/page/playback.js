// Time: which step is shown, and how it goes on. A page derives from it and draws.

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8];

class Playback {
  constructor(lastStep, stepsPerSecond) {
    this.lastStep = lastStep;
    this.stepsPerSecond = stepsPerSecond;
    this.step = 0;
    this.playing = false;
    this.speed = 1;
    this.framesDrawn = 0;
    byId("scrubber").max = lastStep;
    for (const speed of SPEEDS) byId("speed").append(new Option(`${speed}\u00d7`, speed, speed === 1, speed === 1));
    byId("speed").addEventListener("change", () => { this.speed = Number(byId("speed").value); });
    byId("play").addEventListener("click", () => this.toggle());
    byId("back").addEventListener("click", () => this.seek(this.wholeStep() - 1));
    byId("forward").addEventListener("click", () => this.seek(this.wholeStep() + 1));
    byId("scrubber").addEventListener("input", () => this.seek(Number(byId("scrubber").value)));
  }

  wholeStep() { return Math.floor(this.step + 1e-9); }
  timeText(step) { return `${fixed(step / this.stepsPerSecond, 2)} s`; }

  seek(step) {
    this.pause();
    this.step = Math.min(this.lastStep, Math.max(0, Math.round(step)));
    this.redraw();
  }

  play() {
    if (this.step >= this.lastStep) this.step = 0;
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
    this.step = Math.min(this.lastStep, this.step + seconds * this.speed * this.stepsPerSecond);
    if (this.step >= this.lastStep) this.pause();
  }

  changeSpeed(by) {
    const index = Math.min(SPEEDS.length - 1, Math.max(0, SPEEDS.indexOf(this.speed) + by));
    this.speed = SPEEDS[index];
    byId("speed").value = String(this.speed);
  }

  // What a key does to time and view, by the key.
  keyActions(camera, jump) {
    return { " ": () => this.toggle(), ArrowLeft: () => this.seek(this.wholeStep() - jump), ArrowRight: () => this.seek(this.wholeStep() + jump),
             Home: () => this.seek(0), End: () => this.seek(this.lastStep), "+": () => camera.zoom(1.25, this.step), "=": () => camera.zoom(1.25, this.step),
             "-": () => camera.zoom(0.8, this.step), 0: () => camera.fit(), "[": () => this.changeSpeed(-1), "]": () => this.changeSpeed(1) };
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

  showClock() {
    const step = this.wholeStep();
    byId("scrubber").value = step;
    byId("clock").replaceChildren(this.timeText(step), element("span", "", ` step ${step} of ${this.lastStep}`));
  }
}

// Whether the control that has the focus answers a key itself.
function isForControl(event) {
  const typing = event.target.matches("input[type=search], select");
  return typing || (event.key === " " && event.target.matches("button, summary, input[type=checkbox]"));
}
