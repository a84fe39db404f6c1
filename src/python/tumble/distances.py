"""The signed distance of two shapes, with proved bounds."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from tumble import _tumble
from tumble.shapes import Shape, Vector, array_of, number, shape_of, vector
from tumble.vectors import Vec2

STATUS = ("separated", "touching", "overlapping", "invalid")


@dataclass(frozen=True)
class Certificate:
    """The proof of a distance for a checker in exact arithmetic: see include/tumble/distance.hpp."""

    direction: tuple[float, float]
    pairs: list[tuple[int, int]]  #: vertices of a and b
    cores_overlap: bool


@dataclass(frozen=True)
class Distance:
    """The exact signed distance (m, negative if they overlap) lies in [lower, upper]."""

    distance: float
    lower: float
    upper: float
    point_a: Vec2  #: on the surface of a, world, m
    point_b: Vec2  #: on the surface of b
    normal: Vec2  #: unit, from a to b
    status: str  #: "separated", "touching" (the sign is not decided), "overlapping" or "invalid"
    iterations: int
    certificate: Certificate = field(repr=False)

    def __float__(self) -> float:
        return self.distance


@dataclass(frozen=True)
class Trace:
    """The iterations of GJK: each step has simplex, closest, direction, support, lower and upper."""

    steps: list[dict[str, Any]]
    result: Distance
    svg: str = field(repr=False)  #: a drawing of all iterations

    def _repr_svg_(self) -> str:
        return self.svg


def _result(members: dict[str, Any]) -> Distance:
    parts: dict[str, Any] = {name: Vec2(*members[name]) for name in ("point_a", "point_b", "normal")}
    parts["certificate"] = Certificate(**members["certificate"])
    return Distance(**{**members, **parts})


def _posed(shape: Shape, position: Vector, angle: float, name: str) -> tuple[Shape, tuple[float, float], float]:
    checked = shape_of(shape, name, ": World.distance takes bodies")
    return checked, vector(position, f"position_{name}"), number(angle, f"angle_{name}")


def distance(
    a: Shape,
    b: Shape,
    *,
    position_a: Vector = (0.0, 0.0),
    angle_a: float = 0.0,
    position_b: Vector = (0.0, 0.0),
    angle_b: float = 0.0,
) -> Distance:
    """The signed distance of two shapes at their poses (m, rad), with its proof.

    >>> import tumble
    >>> tumble.distance(tumble.circle(1), tumble.box(2, 2), position_b=(4, 0)).distance
    2.0

    A pose that is not finite has the status "invalid" and the distance NaN.
    """
    return _result(_tumble.distance(*_posed(a, position_a, angle_a, "a"), *_posed(b, position_b, angle_b, "b")))


def trace_distance(
    a: Shape,
    b: Shape,
    *,
    position_a: Vector = (0.0, 0.0),
    angle_a: float = 0.0,
    position_b: Vector = (0.0, 0.0),
    angle_b: float = 0.0,
) -> Trace:
    """The same by GJK alone, with every iteration."""
    members = _tumble.trace_distance(*_posed(a, position_a, angle_a, "a"), *_posed(b, position_b, angle_b, "b"))
    return Trace(members["steps"], _result(members["result"]), members["svg"])


def distances(a: Any, poses_a: Any, b: Any, poses_b: Any) -> npt.NDArray[Any]:
    """The distances of many pairs in one call.

    `a` and `b` are a shape each, or lists of n shapes. Poses are arrays [n, 3] of x, y, angle or [n, 4] of x, y, cosine,
    sine (faster); an array of one row serves all pairs. The answer is an array [n] with the members distance, lower,
    upper, point_a, point_b, normal, status (an index into STATUS) and iterations: the same bits as `distance`. A row
    with a pose that is not finite has the status "invalid" and the distance NaN; the other rows are answered.
    """
    counts = [len(shapes) for shapes in (a, b) if not isinstance(shapes, Shape)]
    arrays = []
    for poses, name in ((poses_a, "poses_a"), (poses_b, "poses_b")):
        array = np.atleast_2d(array_of(poses, name))
        if array.ndim != 2 or array.shape[1] not in (3, 4):
            raise ValueError(f"{name} must have the shape (n, 3) or (n, 4), got {array.shape}")
        arrays.append(array)
        counts.append(len(array))
    count = 0 if 0 in counts else max(counts)
    if any(n not in (1, count) for n in counts):
        raise ValueError(f"shapes and poses must have one length, got {counts}")
    return _tumble.distance_batch(a, arrays[0], b, arrays[1], count)
