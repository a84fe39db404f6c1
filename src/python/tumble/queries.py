"""Rays, moving shapes, overlaps and distances.

Units are m, kg, s and rad; y is up and counter-clockwise is positive.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from tumble import _tumble
from tumble.bodies import Body
from tumble.body_shapes import BodyShape
from tumble.parts import id_in
from tumble.shapes import Shape, Vector, array_of, finite, number, points_array, shape_of, vector
from tumble.vectors import Vec2


class Hit(NamedTuple):
    """Where a ray or a moving shape first touches a shape."""

    body: Body
    shape: BodyShape
    fraction: float  #: of the translation, 0 to 1
    point: Vec2  #: on the surface, world, m
    normal: Vec2  #: unit, out of the shape that is hit
    starts_inside: bool


class Closest(NamedTuple):
    """The shape nearest to a point."""

    body: Body
    shape: BodyShape
    distance: float  #: m, negative inside
    point: Vec2  #: on the surface, world, m
    normal: Vec2


class BodyDistance(NamedTuple):
    """The distance of two bodies, and the two nearest points."""

    distance: float  #: m, negative if they overlap
    point_a: Vec2
    point_b: Vec2
    normal: Vec2  #: unit, from a to b


class Queries:
    """The questions that a world answers about the shapes in it."""

    __slots__ = ()

    _box: _tumble.World

    def body(self, id: int) -> Body:
        """The body of an id, as contacts have it."""
        raise NotImplementedError

    def shape(self, id: int) -> BodyShape:
        """The shape of an id, as contacts and events have it."""
        raise NotImplementedError

    def cast_ray(self, origin: Vector, translation: Vector, *, exclude: Body | None = None, mask: int | None = None,
                 sensors: bool = False) -> Hit | None:  # fmt: skip
        """The first shape that a ray from `origin` to `origin + translation` enters."""
        return self._hit(
            self._box.cast_ray(vector(origin, "origin"), vector(translation, "translation"), self._filter(exclude, mask, sensors))
        )

    def cast_ray_all(self, origin: Vector, translation: Vector, *, exclude: Body | None = None, mask: int | None = None,
                     sensors: bool = False) -> list[Hit]:  # fmt: skip
        """All shapes that a ray enters, the nearest first."""
        hits = self._box.cast_ray_all(
            vector(origin, "origin"), vector(translation, "translation"), self._filter(exclude, mask, sensors)
        )
        return [hit for hit in map(self._hit, hits) if hit is not None]

    def cast_rays(self, origins: Any, translations: Any, *, exclude: Body | None = None, mask: int | None = None,
                  sensors: bool = False) -> npt.NDArray[Any]:  # fmt: skip
        """The first hits of many rays [n, 2]: an array [n] of hit, body, shape, fraction, point, normal.

        A ray that hits nothing has the fraction 1 and the ids 0. One origin serves all rays.
        """
        translations = points_array(translations, "translations")
        starts = points_array(np.atleast_2d(array_of(origins, "origins")), "origins")
        if len(starts) == 1:
            starts = np.ascontiguousarray(np.broadcast_to(starts, translations.shape))
        if starts.shape != translations.shape:
            raise ValueError(f"origins {starts.shape} and translations {translations.shape} must have one shape")
        return self._box.cast_rays(starts, translations, self._filter(exclude, mask, sensors))

    def cast_shape(self, shape: Shape, position: Vector, translation: Vector, *, angle: float = 0.0,
                   exclude: Body | None = None, mask: int | None = None, sensors: bool = False) -> Hit | None:  # fmt: skip
        """The first shape that `shape` touches when it moves by `translation` without rotation."""
        return self._hit(
            self._box.cast_shape(
                shape_of(shape, "shape"), vector(position, "position"), finite(angle, "angle"),
                vector(translation, "translation"), self._filter(exclude, mask, sensors)
            )
        )

    def overlap(self, shape: Shape, position: Vector = (0.0, 0.0), angle: float = 0.0, *, exclude: Body | None = None,
                mask: int | None = None, sensors: bool = False) -> list[BodyShape]:  # fmt: skip
        """The shapes that `shape` at a pose overlaps."""
        pose = vector(position, "position"), finite(angle, "angle")
        ids = self._box.overlap_shape(shape_of(shape, "shape"), *pose, self._filter(exclude, mask, sensors))
        return [self.shape(id) for id in ids]

    def overlap_box(self, lower: Vector, upper: Vector, *, exclude: Body | None = None, mask: int | None = None,
                    sensors: bool = False) -> list[BodyShape]:  # fmt: skip
        """The shapes whose bounding boxes overlap a box."""
        ids = self._box.overlap_box(vector(lower, "lower"), vector(upper, "upper"), self._filter(exclude, mask, sensors))
        return [self.shape(id) for id in ids]

    def closest(self, point: Vector, max_distance: float = float("inf"), *, exclude: Body | None = None,
                mask: int | None = None, sensors: bool = False) -> Closest | None:  # fmt: skip
        """The shape nearest to a point, if one is at most `max_distance` m away."""
        furthest = number(max_distance, "max_distance")
        found = self._box.closest(vector(point, "point"), furthest, self._filter(exclude, mask, sensors))
        if found is None:
            return None
        body, shape, distance, at, normal = found
        return Closest(self.body(body), self.shape(shape), distance, Vec2(*at), Vec2(*normal))

    def distance(self, a: Body, b: Body) -> BodyDistance:
        """The signed distance of two bodies."""
        ids = id_in(self._box, a, Body, "a"), id_in(self._box, b, Body, "b")
        distance, point_a, point_b, normal = self._box.distance(*ids)
        return BodyDistance(distance, Vec2(*point_a), Vec2(*point_b), Vec2(*normal))

    def _hit(self, found: tuple[Any, ...] | None) -> Hit | None:
        if found is None:
            return None
        body, shape, fraction, point, normal, inside = found
        return Hit(self.body(body), self.shape(shape), fraction, Vec2(*point), Vec2(*normal), inside)

    def _filter(self, exclude: Body | None, mask: int | None, sensors: bool) -> dict[str, Any]:
        members: dict[str, Any] = {"sensors": sensors}
        if exclude is not None:
            members["exclude"] = id_in(self._box, exclude, Body, "exclude")
        if mask is not None:
            members["filter"] = {"mask": mask}
        return members
