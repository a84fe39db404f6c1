"""The shapes of bodies.

Units are m, kg, s and rad; y is up and counter-clockwise is positive.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from tumble.parts import Part
from tumble.shapes import Shape, user_data_of

if TYPE_CHECKING:
    from tumble.bodies import Body


class Filter(NamedTuple):
    """Which shapes may touch: each one's mask must have a bit of the other's category.

    Two shapes of the same group other than 0 always touch if it is positive, and never if it is negative.
    """

    category: int
    mask: int
    group: int


class BodyShape(Part):
    """A shape of a body."""

    __slots__ = ()

    def __repr__(self) -> str:
        if not self.is_alive:
            return f"<BodyShape {self._id & 0xFFFFFFFF}, removed>"
        return f"<BodyShape {self._id & 0xFFFFFFFF} of body {self.body.id & 0xFFFFFFFF}, {self.shape!r}>"

    @property
    def is_alive(self) -> bool:
        """Whether it is not removed, and its body not destroyed."""
        return self._box.is_shape(self._id)

    def remove(self) -> None:
        """Removes the shape from its body."""
        self._box.remove_shape(self._id)

    @property
    def body(self) -> Body:
        """The body that it is a part of."""
        return self._world.body(self._box.shape_body(self._id))

    @property
    def shape(self) -> Shape:
        """The outline, in coordinates of the body."""
        return self._box.shape(self._id)

    @property
    def sensor(self) -> bool:
        """Whether it reports what touches it, without colliding."""
        return self._box.is_sensor(self._id)

    @property
    def user_data(self) -> int:
        """A number of yours, 0 to 2^64 - 1. It is saved with the world."""
        return self._box.shape_user_data(self._id)

    @user_data.setter
    def user_data(self, value: int) -> None:
        self._box.set_shape_user_data(self._id, user_data_of(value))

    @property
    def friction(self) -> float:
        """>= 0. Two surfaces have the root of the product of theirs."""
        return self._box.material(self._id)["friction"]

    @friction.setter
    def friction(self, value: float) -> None:
        self.set_material(friction=value)

    @property
    def restitution(self) -> float:
        """0 to 1: the part of its speed that an impact keeps. Two surfaces have the larger of theirs."""
        return self._box.material(self._id)["restitution"]

    @restitution.setter
    def restitution(self, value: float) -> None:
        self.set_material(restitution=value)

    @property
    def density(self) -> float:
        """kg/m^2."""
        return self._box.material(self._id)["density"]

    @density.setter
    def density(self, value: float) -> None:
        self.set_material(density=value)

    @property
    def rolling_resistance(self) -> float:
        """>= 0, as a part of the shape's radius."""
        return self._box.material(self._id)["rolling_resistance"]

    @rolling_resistance.setter
    def rolling_resistance(self, value: float) -> None:
        self.set_material(rolling_resistance=value)

    @property
    def tangent_speed(self) -> float:
        """Of a conveyor belt, m/s: positive carries a body on top to the left."""
        return self._box.material(self._id)["tangent_speed"]

    @tangent_speed.setter
    def tangent_speed(self, value: float) -> None:
        self.set_material(tangent_speed=value)

    def set_material(self, **members: float) -> None:
        """Changes density, friction, restitution, rolling_resistance or tangent_speed."""
        self._box.set_material(self._id, {**self._box.material(self._id), **members})

    @property
    def filter(self) -> Filter:
        """Which shapes it may touch. `set_filter` changes it."""
        return Filter(**self._box.filter(self._id))

    def set_filter(self, **members: int) -> None:
        """Changes category, mask or group."""
        self._box.set_filter(self._id, {**self._box.filter(self._id), **members})
