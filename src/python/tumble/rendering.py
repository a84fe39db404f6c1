"""Frames without a display, as numpy arrays and PNG files."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import numpy.typing as npt

from tumble import _tumble
from tumble.shapes import Vector, number, vector, whole

if TYPE_CHECKING:
    from tumble.scene import Run
    from tumble.world import World


def world_of(what: World | Run) -> World:
    """A world, or that of a run, or the right exception."""
    world: Any = getattr(what, "world", what)
    if not isinstance(getattr(world, "_box", None), _tumble.World) or not hasattr(world, "_has_scene"):
        raise TypeError(f"what is drawn must be a world or a run, got {what!r}")
    return cast("World", world)


def render(
    what: World | Run,
    width: int = 640,
    height: int = 360,
    *,
    center: Vector | None = None,
    view_height: float | None = None,
    overlay: Sequence[str] = (),
    theme: str | None = None,
) -> npt.NDArray[np.uint8]:
    """Draws the present state as an array [height, width, 4] of red, green, blue and alpha, top row first.

    The camera has its middle at `center` (world, m) and shows `view_height` m. Pass both to keep it still from frame to
    frame. What is left out is fitted, as by `fitted_camera`: to the bodies that are not static and the ground below them,
    and to all static shapes if these do not make the frame much larger. `overlay` names what to show over the bodies:
    contacts, normals, aabbs, islands, velocity, joints, forces. `theme` is light, dark, print, high_contrast or
    color_blind; without it that of the scene, or light. Width and height are 16 to 8192 pixels. The same state gives the
    same pixels on one machine.
    """
    world = world_of(what)
    size = whole(width, "width", 16, 8192), whole(height, "height", 16, 8192)
    if isinstance(overlay, str):
        raise TypeError("overlay must be a list of names, not a string")
    middle = None if center is None else vector(center, "center")
    shown = None if view_height is None else number(view_height, "view_height")
    if theme is not None and not isinstance(theme, str):
        raise TypeError(f"theme must be a string, got {theme!r}")
    return _tumble.render(world._box, world._has_scene, *size, middle, shown, list(overlay), theme)


def fitted_camera(what: World | Run, aspect_ratio: float = 16.0 / 9.0) -> tuple[tuple[float, float], float]:
    """The center and the view_height that `render` would choose now.

    Of a run: the camera of its first frame, moved with the body that the scene follows. `aspect_ratio` is width / height.
    """
    world = world_of(what)
    return _tumble.fitted_camera(world._box, world._has_scene, number(aspect_ratio, "aspect_ratio"))


def checked_pixels(pixels: npt.NDArray[Any]) -> npt.NDArray[np.uint8]:
    """Pixels [height, width, 4], opaque if they have no alpha, or the right exception."""
    if not isinstance(pixels, np.ndarray) or pixels.dtype != np.uint8:
        raise TypeError("pixels must be an array of uint8")
    if pixels.ndim != 3 or pixels.shape[2] not in (3, 4):
        raise ValueError(f"pixels must have the shape (height, width, 3 or 4), got {pixels.shape}")
    if pixels.shape[2] == 3:
        pixels = np.concatenate([pixels, np.full((*pixels.shape[:2], 1), 255, np.uint8)], axis=2)
    return np.ascontiguousarray(pixels)


def write_png(pixels: npt.NDArray[Any], path: str | os.PathLike[str]) -> None:
    """Writes pixels [height, width, 3 or 4] of uint8. The same pixels give the same bytes. Raises FileError."""
    _tumble.write_png(checked_pixels(pixels), os.fspath(path))


def png_bytes(pixels: npt.NDArray[Any]) -> bytes:
    """The bytes of a PNG file."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "frame.png"
        write_png(pixels, file)
        return file.read_bytes()
