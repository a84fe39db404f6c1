"""Joints of two bodies.

Units are m, kg, s and rad; y is up and counter-clockwise is positive.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from tumble import _tumble
from tumble.bodies import Body
from tumble.parts import Part, id_in, index_of
from tumble.shapes import Vector, number, user_data_of, vector
from tumble.vectors import Vec2


class Joint(Part):
    """A joint of two bodies. `World.add_joint` lists the kinds and their members. A destroyed joint raises ValueError."""

    __slots__ = ()

    def __repr__(self) -> str:
        if not self.is_alive:
            return f"<Joint {self._id & 0xFFFFFFFF}, destroyed>"
        return f"<Joint {self._id & 0xFFFFFFFF}, {self.kind}, position {self.position:.3g}, speed {self.speed:.3g}>"

    @property
    def is_alive(self) -> bool:
        """Whether it is not destroyed."""
        return self._box.is_joint(self._id)

    def destroy(self) -> None:
        """Removes the joint, and the gears on it."""
        self._box.destroy_joint(self._id)

    @property
    def kind(self) -> str:
        """Its kind, as `World.add_joint` takes it."""
        return self._box.joint(self._id)[0]

    @property
    def definition(self) -> dict[str, Any]:
        """All members of the joint, as `World.add_joint` takes them; bodies by their ids."""
        return self._box.joint(self._id)[1]

    def change(self, **members: Any) -> None:
        """Changes members: joint.change(limits=(-1, 1), motor=(2, 100))."""
        self._box.change_joint(self._id, plain_members(self._box, members))

    @property
    def body_a(self) -> Body:
        """The first of its bodies."""
        return Body(self._world, self.definition["body_a"])

    @property
    def body_b(self) -> Body:
        """The second of its bodies."""
        return Body(self._world, self.definition["body_b"])

    @property
    def position(self) -> float:
        """The present angle (rad), displacement or length (m) of the free motion; of a wheel joint, along its axis (m)."""
        return self._box.joint_motion(self._id)[0]

    @property
    def speed(self) -> float:
        """The present speed of `position`, rad/s or m/s. A wheel turns by wheel.angular_velocity - car.angular_velocity."""
        return self._box.joint_motion(self._id)[1]

    @property
    def motor_speed(self) -> float:
        """rad/s or m/s. ValueError if the joint has no motor."""
        motor = self.definition.get("motor")
        if motor is None:
            raise ValueError(f"{self!r} has no motor")
        return float(motor[0])

    @motor_speed.setter
    def motor_speed(self, value: float) -> None:
        self._box.set_motor_speed(self._id, number(value, "motor_speed"))

    @property
    def motor(self) -> tuple[float, float] | None:
        """Speed (rad/s or m/s) and the largest torque (N m) or force (N); None: no motor."""
        return self.definition.get("motor")

    @motor.setter
    def motor(self, value: Vector | None) -> None:
        self.change(motor=value)

    @property
    def limits(self) -> tuple[float, float] | None:
        """The range of the free motion, rad or m; None: no limits."""
        return self.definition.get("limits")

    @limits.setter
    def limits(self, value: Vector | None) -> None:
        self.change(limits=value)

    @property
    def spring(self) -> tuple[float, float] | None:
        """Frequency (Hz) and damping ratio; None: no spring."""
        return self.definition.get("spring")

    @spring.setter
    def spring(self, value: Vector | None) -> None:
        self.change(spring=value)

    def set_target(self, point: Vector) -> None:
        """The world point (m) to which a mouse joint pulls its body B."""
        self._box.set_target(self._id, vector(point, "point"))

    @property
    def force(self) -> Vec2:
        """On body B in the last step, N, world axes."""
        return Vec2(*self._box.reaction(self._id)[0])

    @property
    def torque(self) -> float:
        """On body B in the last step, N m."""
        return self._box.reaction(self._id)[1]

    @property
    def anchors(self) -> tuple[Vec2, Vec2] | None:
        """The points on A and B at which it acts, world, m."""
        anchors = self._box.joint_anchors(self._id)
        return None if anchors is None else (Vec2(*anchors[0]), Vec2(*anchors[1]))

    @property
    def user_data(self) -> int:
        """A number of yours, 0 to 2^64 - 1. It is saved with the world."""
        return self._box.joint_user_data(self._id)

    @user_data.setter
    def user_data(self, value: int) -> None:
        self._box.set_joint_user_data(self._id, user_data_of(value))


_PARTS: dict[str, type[Part]] = {"body_a": Body, "body_b": Body, "joint_a": Joint, "joint_b": Joint}

# Members of two numbers, and what these are.
_PAIRS = {"limits": "lower, upper", "motor": "speed, largest torque or force", "spring": "hertz, damping ratio"}

KINDS = ("revolute", "prismatic", "distance", "weld", "wheel", "motor", "mouse", "filter", "pulley", "gear")


def plain_members(box: _tumble.World, members: Mapping[str, Any]) -> dict[str, Any]:
    """Bodies and joints of the world by id, vectors as tuples."""
    plain: dict[str, Any] = {}
    for name, value in members.items():
        if name in _PARTS:
            value = id_in(box, value, _PARTS[name], name)
        elif name in _PAIRS:
            value = None if value is None else vector(value, f"{name} ({_PAIRS[name]})")
        elif isinstance(value, (list, np.ndarray)):
            value = vector(value, name)
        plain[name] = value
    return plain


def new_members(
    box: _tumble.World, kind: str, body_a: Body | None, body_b: Body | None, members: Mapping[str, Any]
) -> dict[str, Any]:
    """The members of a new joint: points in coordinates of the bodies, and what follows from the present poses."""
    index_of(KINDS, kind, "kind")
    if kind == "gear" and not {"joint_a", "joint_b"} <= members.keys():
        raise TypeError("a gear joint needs joint_a and joint_b")
    if (body_a is None or body_b is None) and kind != "gear":
        raise TypeError(f"a {kind} joint needs two bodies")
    if kind == "mouse" and "max_force" not in members:
        raise TypeError("a mouse joint needs max_force (N), without which it does not pull")
    if kind == "motor" and not {"max_force", "max_torque"} & members.keys():
        raise TypeError("a motor joint needs max_force (N) or max_torque (N m), without which it does not push")
    plain = plain_members(box, members)
    if body_a is None or body_b is None:
        return plain
    plain.update(plain_members(box, {"body_a": body_a, "body_b": body_b}))
    if "anchor" in plain:
        point = vector(plain.pop("anchor"), "anchor")
        plain.update(anchor_a=body_a.world_to_local(point), anchor_b=body_b.world_to_local(point))
    if kind in ("revolute", "prismatic", "weld", "motor"):
        plain.setdefault("reference_angle", wrapped(body_b.angle - body_a.angle))
    if kind == "distance" and "length" not in plain:
        a = body_a.local_to_world(vector(plain.get("anchor_a", (0.0, 0.0)), "anchor_a"))
        b = body_b.local_to_world(vector(plain.get("anchor_b", (0.0, 0.0)), "anchor_b"))
        plain["length"] = (b - a).length
    return plain


def wrapped(angle: float) -> float:
    """The same angle in [-pi, pi)."""
    return float((angle + np.pi) % (2.0 * np.pi) - np.pi)
