// What mouse and fingers do on a canvas: they move and zoom the view.

// `player` has the step and redraws; `tap` gets the pixel of a click.
function movePointers(canvas, camera, player, tap) {
  const down = new Map();
  let moved = 0;
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    camera.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)), player.step, event.offsetX, event.offsetY);
    player.redraw();
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
    drag(camera, player.step, [...down.values()], before, after);
    down.set(event.pointerId, after);
    player.redraw();
  });
  const release = (event) => {
    const isTap = down.size === 1 && moved < 6 && event.type === "pointerup";
    down.delete(event.pointerId);
    if (isTap) tap(event.offsetX, event.offsetY);
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
}

// One finger moves the view, two also zoom it about their middle.
function drag(camera, step, points, before, after) {
  if (points.length === 1) {
    camera.pan(after[0] - before[0], after[1] - before[1]);
    return;
  }
  const other = points.find((point) => point !== before);
  const apart = (point) => Math.hypot(point[0] - other[0], point[1] - other[1]);
  camera.pan((after[0] - before[0]) / 2, (after[1] - before[1]) / 2);
  camera.zoom(apart(after) / Math.max(1, apart(before)), step, (after[0] + other[0]) / 2, (after[1] + other[1]) / 2);
}
