"""Steps of many worlds at once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from tumble import _tumble
from tumble.scene import Run
from tumble.shapes import steps_of, threads_of
from tumble.world import World


def step_all(worlds: Sequence[World | Run], count: int = 1, *, threads: int | None = None) -> None:
    """Steps many worlds or runs at once, each `count` times, without the GIL.

    `threads` is by default one for each processor. Each world is stepped by one thread: this uses processors better than
    threads within a step. If steps raise, the other worlds still make theirs, and the exception of the first is raised.
    """
    if isinstance(worlds, (World, Run)) or not isinstance(worlds, Iterable):
        raise TypeError(f"worlds must be a list of worlds or runs, got {worlds!r}")
    boxes = []
    for world in worlds:
        if not isinstance(world, (World, Run)):
            raise TypeError(f"worlds must be worlds or runs, got {world!r}")
        boxes.append(world._box)
    _tumble.step_all(boxes, steps_of(count), threads_of(threads))
