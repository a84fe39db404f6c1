"""Vectors in the plane, as the package returns them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tumble.shapes import Vector


def _pair(value: Any) -> tuple[float, float] | None:
    """Two numbers to calculate with; None leaves the operation to the other operand, as for arrays."""
    if isinstance(value, np.ndarray) or not isinstance(value, Sequence) or len(value) != 2:
        return None
    return value[0], value[1]


def _scale(value: Any) -> Any:
    """A number of Python to multiply by; None leaves the operation to the other operand."""
    if isinstance(value, (np.integer, np.floating)):
        return value.item()
    return value if isinstance(value, (int, float)) else None


class Vec2(NamedTuple):
    """A position, a velocity or a force: a tuple with `x`, `y` and arithmetic.

    >>> a, b = Vec2(3, 4), Vec2(1, 0)
    >>> a - b, 2 * a, a + (0, 1)
    (Vec2(x=2, y=4), Vec2(x=6, y=8), Vec2(x=3, y=5))
    >>> a.length
    5.0

    With a numpy array it makes an array, with a numpy number a Vec2. Every call that takes a vector takes a Vec2, a tuple,
    a list or an array.
    """

    x: float
    y: float

    @property
    def __array_priority__(self) -> float:
        """Above that of numpy's numbers, which leave an operation to this class, and below that of its arrays, 0."""
        return -1.0

    @property
    def length(self) -> float:
        """The root of x^2 + y^2."""
        return float(np.hypot(self.x, self.y))

    def __add__(self, other: Any) -> Vec2:
        pair = _pair(other)
        if pair is None:
            return NotImplemented
        return Vec2(self.x + pair[0], self.y + pair[1])

    def __radd__(self, other: Any) -> Vec2:
        return self.__add__(other)

    def __sub__(self, other: Any) -> Vec2:
        pair = _pair(other)
        if pair is None:
            return NotImplemented
        return Vec2(self.x - pair[0], self.y - pair[1])

    def __rsub__(self, other: Any) -> Vec2:
        return (-self).__add__(other)

    def __mul__(self, factor: Any) -> Vec2:
        scale = _scale(factor)
        if scale is None:
            return NotImplemented
        return Vec2(self.x * scale, self.y * scale)

    def __rmul__(self, factor: Any) -> Vec2:
        return self.__mul__(factor)

    def __truediv__(self, divisor: Any) -> Vec2:
        scale = _scale(divisor)
        if scale is None:
            return NotImplemented
        return Vec2(self.x / scale, self.y / scale)

    def __neg__(self) -> Vec2:
        return Vec2(-self.x, -self.y)


class VectorProperty(property):
    """A property that gives a Vec2 and takes any vector."""

    if TYPE_CHECKING:  # a plain property has one type for both

        def __get__(self, part: Any, owner: Any = None) -> Vec2: ...

        def __set__(self, part: Any, value: Vector) -> None: ...
