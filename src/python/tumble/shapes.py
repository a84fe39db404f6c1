"""Shapes: convex outlines of one or more points, grown by a radius. Lengths are in m, in coordinates of the body."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from tumble import _tumble
from tumble._tumble import Shape

Vector = Sequence[float] | npt.NDArray[Any]

__all__ = ["Shape", "Vector", "box", "capsule", "circle", "polygon", "segment"]


def number(value: float, name: str) -> float:
    """A number, or the right exception."""
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, got {value!r}") from None
    except OverflowError:
        raise ValueError(f"{name} is too large") from None


def vector(value: Vector, name: str) -> tuple[float, float]:
    """A pair of numbers, or the right exception."""
    try:
        x, y = value
        return float(x), float(y)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be two numbers, got {value!r}") from None
    except OverflowError:
        raise ValueError(f"{name} is too large") from None


def points_array(points: Any, name: str) -> npt.NDArray[np.float64]:
    """An array [n, 2], or the right exception."""
    array = array_of(points, name)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"{name} must have the shape (n, 2), got {array.shape}")
    return array


def array_of(values: Any, name: str, type: Any = np.float64) -> npt.NDArray[Any]:
    """An array of numbers, or the right exception."""
    try:
        return np.ascontiguousarray(values, dtype=type)
    except OverflowError:
        raise ValueError(f"{name} has a number that is too large") from None


def circle(radius: float, center: Vector = (0.0, 0.0)) -> Shape:
    """A disc. `radius` >= 0 m."""
    return _tumble.circle(radius, vector(center, "center"))


def capsule(start: Vector, end: Vector, radius: float) -> Shape:
    """The points within `radius` (m) of a segment."""
    return _tumble.capsule(vector(start, "start"), vector(end, "end"), radius)


def segment(start: Vector, end: Vector) -> Shape:
    """A line that collides on both sides. Use `Body.add_chain` for ground."""
    return _tumble.segment(vector(start, "start"), vector(end, "end"))


def box(width: float, height: float, *, radius: float = 0.0, center: Vector = (0.0, 0.0), angle: float = 0.0) -> Shape:
    """A box of outer size `width` x `height` m with corners rounded by `radius`, turned by `angle` (rad)."""
    return _tumble.box(vector((width, height), "width and height"), radius, vector(center, "center"), angle)


def polygon(points: Any, *, radius: float = 0.0, exact: bool = False) -> Shape:
    """The convex hull of `points`, [n, 2] in any order, grown by `radius`.

    Vertices within a few ulp of an edge are dropped, which suits bodies; `exact` keeps all of them, for distances whose
    bounds must hold for the points as given.
    """
    return _tumble.polygon(points_array(points, "points"), radius, exact)
