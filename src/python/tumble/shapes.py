"""Shapes: convex outlines of one or more points, grown by a radius. Lengths are in m, in coordinates of the body."""

from __future__ import annotations

import operator
import os
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
        if isinstance(value, (str, bytes)):
            raise TypeError
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, got {value!r}") from None
    except OverflowError:
        raise ValueError(f"{name} is too large") from None


def finite(value: float, name: str) -> float:
    """A finite number, or the right exception."""
    checked = number(value, name)
    if not np.isfinite(checked):
        raise ValueError(f"{name} must be finite, got {value!r}")
    return checked


def whole(value: int, name: str, least: int, most: int, hint: str = "") -> int:
    """A whole number from `least` to `most`, or the right exception."""
    wanted = f"{name} must be a whole number from {least} to {most}, got {value!r}{hint}"
    try:
        checked = operator.index(value)
    except TypeError:
        raise TypeError(wanted) from None
    if not least <= checked <= most:
        raise ValueError(wanted)
    return checked


def text_of(value: str, name: str) -> str:
    """A string, or the right exception."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a string, got {value!r}")
    return value


def truth(value: bool, name: str) -> bool:
    """True or False, or the right exception."""
    if not isinstance(value, (bool, np.bool_, int)):
        raise TypeError(f"{name} must be True or False, got {value!r}")
    return bool(value)


def threads_of(count: int | None) -> int:
    """A number of threads, by default one for each processor, or the right exception."""
    return len(os.sched_getaffinity(0)) if count is None else whole(count, "threads", 1, 2**31 - 1)


def steps_of(count: int) -> int:
    """A number of steps, or the right exception."""
    return whole(count, "count", 0, 2**53, ": a step lasts 1 / steps_per_second, which World(...) takes")


def user_data_of(value: int) -> int:
    """A number that a body, a shape or a joint keeps for its user, or the right exception."""
    return whole(value, "user_data", 0, 2**64 - 1, "; keep objects in a dictionary with the body, shape or joint as key")


def shape_of(value: Shape, name: str, hint: str = "") -> Shape:
    """A shape, or the right exception."""
    if not isinstance(value, Shape):
        raise TypeError(f"{name} must be a Shape, as tumble.circle makes it, got {value!r}{hint}")
    return value


def vector(value: Vector, name: str) -> tuple[float, float]:
    """A pair of numbers, or the right exception."""
    try:
        x, y = value
        if isinstance(x, str) or isinstance(y, str):
            raise TypeError
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
        array = np.asarray(values)
        if array.dtype.kind == "c":
            raise TypeError("they are complex")
        return np.ascontiguousarray(array, dtype=type)
    except OverflowError:
        raise ValueError(f"{name} has a number that is too large") from None
    except (TypeError, ValueError) as error:
        raise error.__class__(f"{name} must be an array of numbers: {error}") from None


def circle(radius: float, center: Vector = (0.0, 0.0)) -> Shape:
    """A disc. `radius` >= 0 m."""
    return _tumble.circle(number(radius, "radius"), vector(center, "center"))


def capsule(start: Vector, end: Vector, radius: float) -> Shape:
    """The points within `radius` (m) of a segment."""
    return _tumble.capsule(vector(start, "start"), vector(end, "end"), number(radius, "radius"))


def segment(start: Vector, end: Vector) -> Shape:
    """A line that collides on both sides. Use `Body.add_chain` for ground."""
    return _tumble.segment(vector(start, "start"), vector(end, "end"))


def box(width: float, height: float, *, radius: float = 0.0, center: Vector = (0.0, 0.0), angle: float = 0.0) -> Shape:
    """A box of outer size `width` x `height` m with corners rounded by `radius`, turned by `angle` (rad)."""
    size = number(width, "width"), number(height, "height")
    return _tumble.box(size, number(radius, "radius"), vector(center, "center"), finite(angle, "angle"))


def polygon(points: Any, *, radius: float = 0.0, exact: bool = False) -> Shape:
    """The convex hull of `points`, [n, 2] in any order, grown by `radius`.

    Vertices within a few ulp of an edge are dropped, which suits bodies; `exact` keeps all of them, for distances whose
    bounds must hold for the points as given.
    """
    return _tumble.polygon(points_array(points, "points"), number(radius, "radius"), exact)
