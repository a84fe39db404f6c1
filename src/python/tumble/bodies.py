"""Bodies.

Units are m, kg, s and rad; y is up and counter-clockwise is positive.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from tumble.body_shapes import BodyShape
from tumble.parts import Part, counted, index_of
from tumble.shapes import Shape, Vector, finite, number, points_array, shape_of, truth, user_data_of, vector
from tumble.vectors import Vec2, VectorProperty

if TYPE_CHECKING:
    from tumble.joints import Joint

STATIC, KINEMATIC, DYNAMIC = "static", "kinematic", "dynamic"
BODY_TYPES = (STATIC, KINEMATIC, DYNAMIC)


class Locks(NamedTuple):
    """The motions that a body does not make, along the world axes and about its centre of mass."""

    x: bool
    y: bool
    rotation: bool


class Body(Part):
    """A rigid body. Its properties can be read and set; a destroyed body raises ValueError."""

    __slots__ = ()

    def __repr__(self) -> str:
        if not self.is_alive:
            return f"<Body {self._id & 0xFFFFFFFF}, destroyed>"
        x, y = self.position
        return f"<Body {self._id & 0xFFFFFFFF}, {self.type}, at ({x:.3g}, {y:.3g}) m, {counted(len(self.shapes), 'shape')}>"

    @property
    def is_alive(self) -> bool:
        """Whether it is not destroyed."""
        return self._box.is_body(self._id)

    def destroy(self) -> None:
        """Removes the body with its shapes and joints."""
        self._box.destroy_body(self._id)

    @property
    def type(self) -> str:
        """"static", "kinematic" or "dynamic"."""
        return BODY_TYPES[self._box.type(self._id)]

    @type.setter
    def type(self, value: str) -> None:
        self._box.set_type(self._id, index_of(BODY_TYPES, value, "type"))

    def _position(self) -> Vec2:
        """Of the origin, world, m. Setting it moves the body at once, without collisions on the way."""
        x, y, *_ = self._box.state(self._id)
        return Vec2(x, y)

    def _set_position(self, value: Vector) -> None:
        self._box.set_pose(self._id, vector(value, "position"), self.angle)

    position = VectorProperty(_position, _set_position)

    @property
    def angle(self) -> float:
        """rad in (-pi, pi]."""
        return float(self._box.state(self._id)[2])

    @angle.setter
    def angle(self, value: float) -> None:
        self._box.set_pose(self._id, self.position, finite(value, "angle"))

    def _velocity(self) -> Vec2:
        """Of the centre of mass, m/s."""
        _, _, _, x, y, _ = self._box.state(self._id)
        return Vec2(x, y)

    def _set_velocity(self, value: Vector) -> None:
        self._box.set_velocity(self._id, vector(value, "velocity"), self.angular_velocity)

    velocity = VectorProperty(_velocity, _set_velocity)

    @property
    def angular_velocity(self) -> float:
        """rad/s, counter-clockwise positive."""
        return float(self._box.state(self._id)[5])

    @angular_velocity.setter
    def angular_velocity(self, value: float) -> None:
        self._box.set_velocity(self._id, self.velocity, number(value, "angular_velocity"))

    def local_to_world(self, point: Vector) -> Vec2:
        """The world point (m) of a point in coordinates of the body."""
        x, y = vector(point, "point")
        c, s = np.cos(self.angle), np.sin(self.angle)
        return self.position + (float(c * x - s * y), float(s * x + c * y))

    def world_to_local(self, point: Vector) -> Vec2:
        """The coordinates (m) of a world point in the body."""
        dx, dy = Vec2(*vector(point, "point")) - self.position
        c, s = np.cos(self.angle), np.sin(self.angle)
        return Vec2(float(c * dx + s * dy), float(c * dy - s * dx))

    def velocity_at(self, point: Vector) -> Vec2:
        """The velocity (m/s) of the point of the body that is at a world point."""
        return Vec2(*self._box.velocity_at(self._id, vector(point, "point")))

    def move_towards(self, position: Vector, angle: float = 0.0) -> None:
        """Sets the velocity that reaches a pose in the next step: for kinematic bodies."""
        self._box.move_towards(self._id, vector(position, "position"), finite(angle, "angle"))

    @property
    def mass(self) -> float:
        """kg; 0 for bodies that are not dynamic. Setting it scales the inertia of the shapes too."""
        return self._box.mass(self._id)[0]

    @mass.setter
    def mass(self, value: float) -> None:
        mass, center, inertia = self._box.mass(self._id)
        value = number(value, "mass")
        self._box.set_mass(self._id, (value, center, inertia * value / mass if mass > 0.0 else 0.0))

    @property
    def inertia(self) -> float:
        """About the centre of mass, kg m^2; 0 means that nothing turns the body."""
        return self._box.mass(self._id)[2]

    @property
    def center_of_mass(self) -> Vec2:
        """In coordinates of the body, m."""
        return Vec2(*self._box.mass(self._id)[1])

    def set_mass(self, mass: float, center: Vector = (0.0, 0.0), inertia: float = 0.0) -> None:
        """Replaces mass (kg), centre (body coordinates, m) and inertia (kg m^2) of the shapes.

        Without `inertia` the body does not turn. To keep the centre and the form of the inertia set `mass`.
        """
        self._box.set_mass(
            self._id, (number(mass, "mass"), vector(center, "center"), number(inertia, "inertia"))
        )

    def reset_mass(self) -> None:
        """Takes the mass of the shapes again."""
        self._box.set_mass(self._id, None)

    def apply_force(self, force: Vector, point: Vector | None = None) -> None:
        """A force (N, world axes) during the next step, at a world point or at the centre of mass."""
        self._box.apply_force(self._id, vector(force, "force"), None if point is None else vector(point, "point"))

    def apply_impulse(self, impulse: Vector, point: Vector | None = None) -> None:
        """An impulse (N s, world axes) at once, at a world point or at the centre of mass."""
        self._box.apply_impulse(self._id, vector(impulse, "impulse"), None if point is None else vector(point, "point"))

    def apply_torque(self, torque: float) -> None:
        """A torque (N m) during the next step."""
        self._box.apply_torque(self._id, number(torque, "torque"))

    def apply_angular_impulse(self, impulse: float) -> None:
        """An angular impulse (N m s) at once."""
        self._box.apply_angular_impulse(self._id, number(impulse, "impulse"))

    @property
    def awake(self) -> bool:
        """False while it sleeps. Setting it wakes all bodies that touch or are joined, or puts them to sleep."""
        return self._box.is_awake(self._id)

    @awake.setter
    def awake(self, value: bool) -> None:
        self._box.set_awake(self._id, truth(value, "awake"))

    def _member(self, name: str) -> Any:
        return self._box.body_definition(self._id)[name]

    @property
    def enabled(self) -> bool:
        """A disabled body keeps its place, but does not move or collide."""
        return bool(self._member("enabled"))

    @enabled.setter
    def enabled(self, value: bool) -> None:
        self._box.set_enabled(self._id, truth(value, "enabled"))

    @property
    def bullet(self) -> bool:
        """With impacts "at_step_end": whether it is swept against dynamic bodies too. With "in_order" all bodies are."""
        return bool(self._member("bullet"))

    @bullet.setter
    def bullet(self, value: bool) -> None:
        self._box.set_bullet(self._id, truth(value, "bullet"))

    @property
    def allow_sleep(self) -> bool:
        """False keeps it and all that it touches awake."""
        return bool(self._member("allow_sleep"))

    @allow_sleep.setter
    def allow_sleep(self, value: bool) -> None:
        self._box.set_allow_sleep(self._id, truth(value, "allow_sleep"))

    @property
    def allow_fast_rotation(self) -> bool:
        """Whether it may turn by more than 1/8 turn in a step: for round shapes."""
        return bool(self._member("allow_fast_rotation"))

    @allow_fast_rotation.setter
    def allow_fast_rotation(self, value: bool) -> None:
        self._box.set_allow_fast_rotation(self._id, truth(value, "allow_fast_rotation"))

    @property
    def gravity_scale(self) -> float:
        """The factor on the world's gravity."""
        return float(self._member("gravity_scale"))

    @gravity_scale.setter
    def gravity_scale(self, value: float) -> None:
        self._box.set_gravity_scale(self._id, number(value, "gravity_scale"))

    @property
    def linear_damping(self) -> float:
        """1/s."""
        return float(self._member("linear_damping"))

    @linear_damping.setter
    def linear_damping(self, value: float) -> None:
        self._box.set_damping(self._id, number(value, "linear_damping"), self.angular_damping)

    @property
    def angular_damping(self) -> float:
        """1/s."""
        return float(self._member("angular_damping"))

    @angular_damping.setter
    def angular_damping(self, value: float) -> None:
        self._box.set_damping(self._id, self.linear_damping, number(value, "angular_damping"))

    @property
    def locks(self) -> Locks:
        """The motions that it does not make. `lock` sets them."""
        return Locks(*self._member("locks"))

    def lock(self, *, x: bool = False, y: bool = False, rotation: bool = False) -> None:
        """Locks motions along the world axes and the rotation; those left out are free."""
        self._box.set_locks(self._id, truth(x, "x"), truth(y, "y"), truth(rotation, "rotation"))

    @property
    def user_data(self) -> int:
        """A number of yours, 0 to 2^64 - 1. It is saved with the world."""
        return self._box.body_user_data(self._id)

    @user_data.setter
    def user_data(self, value: int) -> None:
        self._box.set_body_user_data(self._id, user_data_of(value))

    @property
    def shapes(self) -> list[BodyShape]:
        """In the order in which they were added."""
        return [BodyShape(self._world, id) for id in self._box.shapes_of(self._id)]

    @property
    def joints(self) -> list[Joint]:
        """The joints of this body, in the order of their creation."""
        return self._world._joints_of(self._id)

    @property
    def contacts(self) -> npt.NDArray[Any]:
        """The contact points of this body after the last step, as `World.contacts`."""
        return self._box.contacts_of(self._id)

    def add_shape(
        self,
        shape: Shape,
        *,
        density: float = 1.0,
        friction: float = 0.6,
        restitution: float = 0.0,
        rolling_resistance: float = 0.0,
        tangent_speed: float = 0.0,
        sensor: bool = False,
        category: int = 1,
        mask: int = 0xFFFFFFFFFFFFFFFF,
        group: int = 0,
        user_data: int = 0,
    ) -> BodyShape:
        """Adds a shape. Density is in kg/m^2; a sensor reports what touches it and has no mass."""
        id = self._box.add_shape(
            self._id,
            shape_of(shape, "shape"),
            {
                "material": {
                    "density": density,
                    "friction": friction,
                    "restitution": restitution,
                    "rolling_resistance": rolling_resistance,
                    "tangent_speed": tangent_speed,
                },
                "filter": {"category": category, "mask": mask, "group": group},
                "sensor": sensor,
                "user_data": user_data_of(user_data),
            },
        )
        return BodyShape(self._world, id)

    def add_chain(
        self, points: Any, *, loop: bool = False, two_sided: bool = False, friction: float = 0.6, restitution: float = 0.0
    ) -> list[BodyShape]:
        """Adds segments through `points` [n, 2] over which shapes slide smoothly, solid on the left of their direction.

        So the points of a ground go from right to left, and those of a room clockwise: what comes from the other side
        passes through. `two_sided` makes it solid on both sides. `loop` joins the last point to the first.
        """
        material = {"friction": friction, "restitution": restitution}
        line = points_array(points, "points"), truth(loop, "loop"), truth(two_sided, "two_sided")
        ids = self._box.add_chain(self._id, *line, {"material": material})
        return [BodyShape(self._world, id) for id in ids]
