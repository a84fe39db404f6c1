"""Worlds, and the bodies, shapes and joints in them.

Units are m, kg, s and rad; y is up and counter-clockwise is positive.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from tumble import _tumble
from tumble.shapes import Shape, Vector, points_array, vector

STATIC, KINEMATIC, DYNAMIC = "static", "kinematic", "dynamic"
_TYPES = (STATIC, KINEMATIC, DYNAMIC)
_SOLVERS = ("iterative", "direct")
_IMPACTS = ("at_step_end", "in_order")


def _index(names: Sequence[str], name: str, what: str) -> int:
    if name not in names:
        raise ValueError(f"{what} must be one of {', '.join(names)}, got {name!r}")
    return names.index(name)


class Hit(NamedTuple):
    """Where a ray or a moving shape first touches a shape."""

    body: Body
    shape: BodyShape
    fraction: float  #: of the way, 0 to 1
    point: tuple[float, float]  #: on the surface, world, m
    normal: tuple[float, float]  #: unit, out of the shape that is hit
    starts_inside: bool


class Closest(NamedTuple):
    """The shape nearest to a point."""

    body: Body
    shape: BodyShape
    distance: float  #: m, negative inside
    point: tuple[float, float]  #: on the surface, world, m
    normal: tuple[float, float]


class BodyDistance(NamedTuple):
    """The distance of two bodies, and the two nearest points."""

    distance: float  #: m, negative if they overlap
    point_a: tuple[float, float]
    point_b: tuple[float, float]
    normal: tuple[float, float]  #: unit, from a to b


class _Part:
    """Something in a world, by its id. Equal if world and id are equal."""

    __slots__ = ("_box", "_id", "_world")

    def __init__(self, world: World, id: int) -> None:
        self._world = world
        self._box = world._box
        self._id = id

    @property
    def world(self) -> World:
        return self._world

    @property
    def id(self) -> int:
        """The number that contacts and events name it by."""
        return self._id

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._id == other._id and self._box is other._box  # type: ignore[attr-defined]

    def __hash__(self) -> int:
        return hash((type(self).__name__, self._id))


class Body(_Part):
    """A rigid body. Its properties can be read and set; a destroyed body raises ValueError."""

    __slots__ = ()

    def __repr__(self) -> str:
        if not self.is_alive:
            return f"<Body {self._id & 0xFFFFFFFF}, destroyed>"
        x, y = self.position
        return f"<Body {self._id & 0xFFFFFFFF}, {self.type}, at ({x:.3g}, {y:.3g}) m, {len(self.shapes)} shapes>"

    @property
    def is_alive(self) -> bool:
        return self._box.is_body(self._id)

    def destroy(self) -> None:
        """Removes the body with its shapes and joints."""
        self._box.destroy_body(self._id)

    @property
    def type(self) -> str:
        """"static", "kinematic" or "dynamic"."""
        return _TYPES[self._box.type(self._id)]

    @type.setter
    def type(self, value: str) -> None:
        self._box.set_type(self._id, _index(_TYPES, value, "type"))

    @property
    def position(self) -> tuple[float, float]:
        """Of the origin, world, m. Setting it moves the body at once, without collisions on the way."""
        x, y, *_ = self._box.state(self._id)
        return x, y

    @position.setter
    def position(self, value: Vector) -> None:
        self._box.set_pose(self._id, vector(value, "position"), self.angle)

    @property
    def angle(self) -> float:
        """rad in (-pi, pi]."""
        return float(self._box.state(self._id)[2])

    @angle.setter
    def angle(self, value: float) -> None:
        self._box.set_pose(self._id, self.position, value)

    @property
    def velocity(self) -> tuple[float, float]:
        """Of the centre of mass, m/s."""
        _, _, _, x, y, _ = self._box.state(self._id)
        return x, y

    @velocity.setter
    def velocity(self, value: Vector) -> None:
        self._box.set_velocity(self._id, vector(value, "velocity"), self.angular_velocity)

    @property
    def angular_velocity(self) -> float:
        """rad/s, counter-clockwise positive."""
        return float(self._box.state(self._id)[5])

    @angular_velocity.setter
    def angular_velocity(self, value: float) -> None:
        self._box.set_velocity(self._id, self.velocity, value)

    def velocity_at(self, point: Vector) -> tuple[float, float]:
        """The velocity (m/s) of the point of the body that is at a world point."""
        return self._box.velocity_at(self._id, vector(point, "point"))

    def move_towards(self, position: Vector, angle: float = 0.0) -> None:
        """Sets the velocity that reaches a pose in the next step: for kinematic bodies."""
        self._box.move_towards(self._id, vector(position, "position"), angle)

    @property
    def mass(self) -> float:
        """kg; 0 for bodies that are not dynamic. Setting it scales the inertia of the shapes too."""
        return self._box.mass(self._id)[0]

    @mass.setter
    def mass(self, value: float) -> None:
        mass, center, inertia = self._box.mass(self._id)
        self._box.set_mass(self._id, (value, center, inertia * value / mass if mass > 0.0 else 0.0))

    @property
    def inertia(self) -> float:
        """About the centre of mass, kg m^2; 0 means that nothing turns the body."""
        return self._box.mass(self._id)[2]

    @property
    def center_of_mass(self) -> tuple[float, float]:
        """In coordinates of the body, m."""
        return self._box.mass(self._id)[1]

    def set_mass(self, mass: float, center: Vector = (0.0, 0.0), inertia: float = 0.0) -> None:
        """Replaces mass (kg), centre (body coordinates, m) and inertia (kg m^2) of the shapes."""
        self._box.set_mass(self._id, (mass, vector(center, "center"), inertia))

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
        self._box.apply_torque(self._id, torque)

    def apply_angular_impulse(self, impulse: float) -> None:
        """An angular impulse (N m s) at once."""
        self._box.apply_angular_impulse(self._id, impulse)

    @property
    def awake(self) -> bool:
        return self._box.is_awake(self._id)

    @awake.setter
    def awake(self, value: bool) -> None:
        self._box.set_awake(self._id, value)

    def _member(self, name: str) -> Any:
        return self._box.body_definition(self._id)[name]

    @property
    def enabled(self) -> bool:
        """A disabled body keeps its place, but does not move or collide."""
        return bool(self._member("enabled"))

    @enabled.setter
    def enabled(self, value: bool) -> None:
        self._box.set_enabled(self._id, value)

    @property
    def bullet(self) -> bool:
        """Whether it does not pass through dynamic bodies either, however fast it is."""
        return bool(self._member("bullet"))

    @bullet.setter
    def bullet(self, value: bool) -> None:
        self._box.set_bullet(self._id, value)

    @property
    def gravity_scale(self) -> float:
        return float(self._member("gravity_scale"))

    @gravity_scale.setter
    def gravity_scale(self, value: float) -> None:
        self._box.set_gravity_scale(self._id, value)

    @property
    def linear_damping(self) -> float:
        """1/s."""
        return float(self._member("linear_damping"))

    @linear_damping.setter
    def linear_damping(self, value: float) -> None:
        self._box.set_damping(self._id, value, self.angular_damping)

    @property
    def angular_damping(self) -> float:
        """1/s."""
        return float(self._member("angular_damping"))

    @angular_damping.setter
    def angular_damping(self, value: float) -> None:
        self._box.set_damping(self._id, self.linear_damping, value)

    def lock(self, *, x: bool = False, y: bool = False, rotation: bool = False) -> None:
        """Locks motions along the world axes and the rotation; those left out are free."""
        self._box.set_locks(self._id, x, y, rotation)

    @property
    def user_data(self) -> int:
        """A number of yours, 0 to 2^64 - 1. It is saved with the world."""
        return self._box.body_user_data(self._id)

    @user_data.setter
    def user_data(self, value: int) -> None:
        self._box.set_body_user_data(self._id, value)

    @property
    def shapes(self) -> list[BodyShape]:
        return [BodyShape(self._world, id) for id in self._box.shapes_of(self._id)]

    @property
    def joints(self) -> list[Joint]:
        return [Joint(self._world, id) for id in self._box.joints_of(self._id)]

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
            shape,
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
                "user_data": user_data,
            },
        )
        return BodyShape(self._world, id)

    def add_chain(
        self, points: Any, *, loop: bool = False, two_sided: bool = False, friction: float = 0.6, restitution: float = 0.0
    ) -> list[BodyShape]:
        """Adds segments through `points` [n, 2] over which shapes slide smoothly, solid on the left of their direction."""
        material = {"friction": friction, "restitution": restitution}
        ids = self._box.add_chain(self._id, points_array(points, "points"), loop, two_sided, {"material": material})
        return [BodyShape(self._world, id) for id in ids]


class BodyShape(_Part):
    """A shape of a body."""

    __slots__ = ()

    def __repr__(self) -> str:
        if not self.is_alive:
            return f"<BodyShape {self._id & 0xFFFFFFFF}, removed>"
        return f"<BodyShape {self._id & 0xFFFFFFFF} of body {self.body.id & 0xFFFFFFFF}, {self.shape!r}>"

    @property
    def is_alive(self) -> bool:
        return self._box.is_shape(self._id)

    def remove(self) -> None:
        self._box.remove_shape(self._id)

    @property
    def body(self) -> Body:
        return Body(self._world, self._box.shape_body(self._id))

    @property
    def shape(self) -> Shape:
        """The outline, in coordinates of the body."""
        return self._box.shape(self._id)

    @property
    def sensor(self) -> bool:
        return self._box.is_sensor(self._id)

    @property
    def user_data(self) -> int:
        """A number of yours, 0 to 2^64 - 1. It is saved with the world."""
        return self._box.shape_user_data(self._id)

    @user_data.setter
    def user_data(self, value: int) -> None:
        self._box.set_shape_user_data(self._id, value)

    @property
    def friction(self) -> float:
        return float(self._box.material(self._id)["friction"])

    @friction.setter
    def friction(self, value: float) -> None:
        self.set_material(friction=value)

    @property
    def restitution(self) -> float:
        return float(self._box.material(self._id)["restitution"])

    @restitution.setter
    def restitution(self, value: float) -> None:
        self.set_material(restitution=value)

    @property
    def density(self) -> float:
        """kg/m^2."""
        return float(self._box.material(self._id)["density"])

    @density.setter
    def density(self, value: float) -> None:
        self.set_material(density=value)

    def set_material(self, **members: float) -> None:
        """Changes density, friction, restitution, rolling_resistance or tangent_speed."""
        self._box.set_material(self._id, {**self._box.material(self._id), **members})

    def set_filter(self, **members: int) -> None:
        """Changes category, mask or group."""
        self._box.set_filter(self._id, {**self._box.filter(self._id), **members})


class Joint(_Part):
    """A joint of two bodies. `World.add_joint` lists the kinds and their members."""

    __slots__ = ()

    def __repr__(self) -> str:
        if not self.is_alive:
            return f"<Joint {self._id & 0xFFFFFFFF}, destroyed>"
        return f"<Joint {self._id & 0xFFFFFFFF}, {self.kind}, position {self.position:.3g}, speed {self.speed:.3g}>"

    @property
    def is_alive(self) -> bool:
        return self._box.is_joint(self._id)

    def destroy(self) -> None:
        self._box.destroy_joint(self._id)

    @property
    def kind(self) -> str:
        return self._box.joint(self._id)[0]

    @property
    def definition(self) -> dict[str, Any]:
        """All members of the joint, as `World.add_joint` takes them; bodies by their ids."""
        return self._box.joint(self._id)[1]

    def change(self, **members: Any) -> None:
        """Changes members: joint.change(limits=(-1, 1), motor=(2, 100))."""
        self._box.change_joint(self._id, _joint_members(members))

    @property
    def body_a(self) -> Body:
        return Body(self._world, self.definition["body_a"])

    @property
    def body_b(self) -> Body:
        return Body(self._world, self.definition["body_b"])

    @property
    def position(self) -> float:
        """The present angle (rad), displacement or length (m) of the free motion."""
        return self._box.joint_motion(self._id)[0]

    @property
    def speed(self) -> float:
        """The present speed of the free motion, rad/s or m/s."""
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
        self._box.set_motor_speed(self._id, value)

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
    def force(self) -> tuple[float, float]:
        """On body B in the last step, N, world axes."""
        return self._box.reaction(self._id)[0]

    @property
    def torque(self) -> float:
        """On body B in the last step, N m."""
        return self._box.reaction(self._id)[1]

    @property
    def anchors(self) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """The points on A and B at which it acts, world, m."""
        return self._box.joint_anchors(self._id)

    @property
    def user_data(self) -> int:
        """A number of yours, 0 to 2^64 - 1. It is saved with the world."""
        return self._box.joint_user_data(self._id)

    @user_data.setter
    def user_data(self, value: int) -> None:
        self._box.set_joint_user_data(self._id, value)


def _joint_members(members: Mapping[str, Any]) -> dict[str, Any]:
    """Bodies and joints by id, vectors as tuples."""
    plain: dict[str, Any] = {}
    for name, value in members.items():
        if isinstance(value, _Part):
            value = value.id
        elif isinstance(value, (list, np.ndarray)):
            value = vector(value, name)
        plain[name] = value
    return plain


class World:
    """A rigid-body simulation in two dimensions with a fixed time step.

    >>> import tumble
    >>> world = tumble.World(gravity=(0, -10))
    >>> ground = world.add_body("static", shapes=[tumble.box(40, 1)], position=(0, -0.5))
    >>> ball = world.add_body(shapes=[tumble.circle(0.5)], position=(0, 4))
    >>> world.step(120)
    >>> round(ball.position[1], 2)
    0.5

    The same calls give the same bits in every run. A world can be pickled and copied; one thread at a time may use it.
    """

    def __init__(
        self,
        *,
        gravity: Vector = (0.0, -10.0),
        steps_per_second: float = 60.0,
        substeps: int = 4,
        sleeping: bool = True,
        continuous: bool = True,
        joints: str = "iterative",
        impacts: str = "at_step_end",
        scale: float = 1.0,
    ) -> None:
        self._has_scene = False
        self._box = _tumble.World(
            {
                "gravity": vector(gravity, "gravity"),
                "steps_per_second": steps_per_second,
                "substeps": substeps,
                "sleeping": sleeping,
                "continuous": continuous,
                "joints": _index(_SOLVERS, joints, "joints"),
                "impacts": _index(_IMPACTS, impacts, "impacts"),
                "scale": scale,
            }
        )

    @classmethod
    def _of(cls, box: _tumble.World, has_scene: bool) -> World:
        world = cls.__new__(cls)
        world._box = box
        world._has_scene = has_scene
        return world

    def __repr__(self) -> str:
        bodies, joints, contacts, awake = self._box.counts()
        return (
            f"<World at {self.time:.3f} s: {bodies} bodies ({awake} awake), {joints} joints, "
            f"{contacts} contacts, hash {self.state_hash}>"
        )

    # ---- Stepping ----

    def step(self, count: int = 1) -> None:
        """Makes `count` steps of 1 / steps_per_second, without the GIL. The world of a run applies its timeline too.

        Raises SimulationDiverged if a pose is not finite any more.
        """
        self._box.step(count)

    @property
    def time(self) -> float:
        """s."""
        return self._box.time()

    @property
    def step_count(self) -> int:
        return self._box.step_count()

    @property
    def dt(self) -> float:
        """The duration of a step, s."""
        return 1.0 / float(self._box.definition()["steps_per_second"])

    @property
    def gravity(self) -> tuple[float, float]:
        """m/s^2."""
        x, y = self._box.definition()["gravity"]
        return x, y

    @gravity.setter
    def gravity(self, value: Vector) -> None:
        self._box.set_gravity(vector(value, "gravity"))

    @property
    def state_hash(self) -> str:
        """16 hexadecimal digits of poses, velocities and sleep: equal worlds have equal hashes on every machine."""
        return f"{self._box.state_hash():016x}"

    # ---- States as arrays ----

    @property
    def ids(self) -> npt.NDArray[np.uint64]:
        """The ids of all bodies, [n]: the order of the arrays below."""
        return self._box.ids()

    @property
    def positions(self) -> npt.NDArray[np.float64]:
        """Of all bodies, [n, 2], m: a read-only view, without a copy.

        A view that you keep shows every later step. When bodies are created or destroyed, the world makes new arrays, and
        the old view keeps its last values.
        """
        return self._box.array(0)

    @property
    def angles(self) -> npt.NDArray[np.float64]:
        """Of all bodies, [n], rad in (-pi, pi]. A view, as `positions`."""
        return self._box.array(1)

    @property
    def velocities(self) -> npt.NDArray[np.float32]:
        """Of all centres of mass, [n, 2], m/s. A view, as `positions`."""
        return self._box.array(2)

    @property
    def angular_velocities(self) -> npt.NDArray[np.float32]:
        """Of all bodies, [n], rad/s. A view, as `positions`."""
        return self._box.array(3)

    # ---- Bodies and joints ----

    def add_body(
        self,
        type: str = DYNAMIC,
        *,
        position: Vector = (0.0, 0.0),
        angle: float = 0.0,
        velocity: Vector = (0.0, 0.0),
        angular_velocity: float = 0.0,
        shapes: Sequence[Shape] = (),
        density: float = 1.0,
        friction: float = 0.6,
        restitution: float = 0.0,
        linear_damping: float = 0.0,
        angular_damping: float = 0.0,
        gravity_scale: float = 1.0,
        bullet: bool = False,
        allow_sleep: bool = True,
        allow_fast_rotation: bool = False,
        awake: bool = True,
        user_data: int = 0,
    ) -> Body:
        """Creates a body, with shapes of one material. `Body.add_shape` adds others."""
        x, y = vector(position, "position")
        id = self._box.create_body(
            {
                "type": _index(_TYPES, type, "type"),
                "pose": (x, y, float(angle)),
                "linear_damping": linear_damping,
                "angular_damping": angular_damping,
                "gravity_scale": gravity_scale,
                "bullet": bullet,
                "allow_sleep": allow_sleep,
                "allow_fast_rotation": allow_fast_rotation,
                "awake": awake,
                "user_data": user_data,
            }
        )
        body = Body(self, id)
        try:
            for shape in shapes:
                body.add_shape(shape, density=density, friction=friction, restitution=restitution)
            if awake and (tuple(velocity) != (0.0, 0.0) or angular_velocity != 0.0):
                self._box.set_velocity(id, vector(velocity, "velocity"), angular_velocity)
        except BaseException:
            body.destroy()
            raise
        return body

    @property
    def bodies(self) -> list[Body]:
        """In the order of their ids, which is that of `positions`."""
        return [Body(self, int(id)) for id in self._box.ids()]

    def body(self, id: int) -> Body:
        """The body of an id, as contacts have it."""
        if not self._box.is_body(int(id)):
            raise ValueError(f"there is no body with the id {id}")
        return Body(self, int(id))

    def shape(self, id: int) -> BodyShape:
        """The shape of an id, as contacts and events have it."""
        if not self._box.is_shape(int(id)):
            raise ValueError(f"there is no shape with the id {id}")
        return BodyShape(self, int(id))

    def add_joint(self, kind: str, body_a: Body | None = None, body_b: Body | None = None, **members: Any) -> Joint:
        """Creates a joint.

        Kinds: revolute, prismatic, distance, weld, wheel, motor, mouse, filter, pulley, gear. `anchor` is a world point
        (m) for both bodies, or `anchor_a` and `anchor_b` are points in coordinates of each. Other members: `axis` (in
        A's coordinates), `limits` (lower, upper), `motor` (speed, largest torque or force), `spring` (hertz, damping
        ratio), `length`, `reference_angle`, `max_force`, `break_force`, `collide_connected`... An angle is measured from
        the poses at creation unless `reference_angle` is given; a rod without `length` keeps the present one.
        """
        if (body_a is None or body_b is None) and kind != "gear":
            raise TypeError(f"a {kind} joint needs two bodies")
        plain = _joint_members(members)
        if body_a is not None and body_b is not None:
            if body_a.world._box is not self._box or body_b.world._box is not self._box:
                raise ValueError("a joint needs two bodies of this world")
            plain.update(body_a=body_a.id, body_b=body_b.id)
            if "anchor" in plain:
                point = vector(plain.pop("anchor"), "anchor")
                plain.update(anchor_a=_to_local(body_a, point), anchor_b=_to_local(body_b, point))
            if kind in ("revolute", "prismatic", "weld", "motor"):
                plain.setdefault("reference_angle", _wrapped(body_b.angle - body_a.angle))
            if kind == "distance" and "length" not in plain:
                a = _to_world(body_a, plain.get("anchor_a", (0.0, 0.0)))
                b = _to_world(body_b, plain.get("anchor_b", (0.0, 0.0)))
                plain["length"] = float(np.hypot(b[0] - a[0], b[1] - a[1]))
        return Joint(self, self._box.create_joint(kind, plain))

    @property
    def joints(self) -> list[Joint]:
        return [Joint(self, id) for id in self._box.joints()]

    # ---- Queries ----

    def cast_ray(self, origin: Vector, translation: Vector, *, exclude: Body | None = None, mask: int | None = None,
                 sensors: bool = False) -> Hit | None:  # fmt: skip
        """The first shape that a ray from `origin` to `origin + translation` enters."""
        return self._hit(
            self._box.cast_ray(vector(origin, "origin"), vector(translation, "translation"), _filter(exclude, mask, sensors))
        )

    def cast_ray_all(self, origin: Vector, translation: Vector, *, exclude: Body | None = None, mask: int | None = None,
                     sensors: bool = False) -> list[Hit]:  # fmt: skip
        """All shapes that a ray enters, the nearest first."""
        hits = self._box.cast_ray_all(
            vector(origin, "origin"), vector(translation, "translation"), _filter(exclude, mask, sensors)
        )
        return [hit for hit in map(self._hit, hits) if hit is not None]

    def cast_rays(self, origins: Any, translations: Any, *, exclude: Body | None = None, mask: int | None = None,
                  sensors: bool = False) -> npt.NDArray[Any]:  # fmt: skip
        """The first hits of many rays [n, 2]: an array [n] of hit, body, shape, fraction, point, normal.

        A ray that hits nothing has the fraction 1 and the ids 0. One origin serves all rays.
        """
        ways = points_array(translations, "translations")
        starts = points_array(np.atleast_2d(origins), "origins")
        if len(starts) == 1:
            starts = np.ascontiguousarray(np.broadcast_to(starts, ways.shape))
        if starts.shape != ways.shape:
            raise ValueError(f"origins {starts.shape} and translations {ways.shape} must have one shape")
        return self._box.cast_rays(starts, ways, _filter(exclude, mask, sensors))

    def cast_shape(self, shape: Shape, position: Vector, translation: Vector, *, angle: float = 0.0,
                   exclude: Body | None = None, mask: int | None = None, sensors: bool = False) -> Hit | None:  # fmt: skip
        """The first shape that `shape` touches when it moves by `translation` without rotation."""
        return self._hit(
            self._box.cast_shape(
                shape, vector(position, "position"), angle, vector(translation, "translation"), _filter(exclude, mask, sensors)
            )
        )

    def overlap(self, shape: Shape, position: Vector = (0.0, 0.0), angle: float = 0.0, *, exclude: Body | None = None,
                mask: int | None = None, sensors: bool = False) -> list[BodyShape]:  # fmt: skip
        """The shapes that `shape` at a pose overlaps."""
        ids = self._box.overlap_shape(shape, vector(position, "position"), angle, _filter(exclude, mask, sensors))
        return [BodyShape(self, id) for id in ids]

    def overlap_box(self, lower: Vector, upper: Vector, *, exclude: Body | None = None, mask: int | None = None,
                    sensors: bool = False) -> list[BodyShape]:  # fmt: skip
        """The shapes whose bounding boxes overlap a box."""
        ids = self._box.overlap_box(vector(lower, "lower"), vector(upper, "upper"), _filter(exclude, mask, sensors))
        return [BodyShape(self, id) for id in ids]

    def closest(self, point: Vector, max_distance: float = float("inf"), *, exclude: Body | None = None,
                mask: int | None = None, sensors: bool = False) -> Closest | None:  # fmt: skip
        """The shape nearest to a point, if one is at most `max_distance` m away."""
        found = self._box.closest(vector(point, "point"), max_distance, _filter(exclude, mask, sensors))
        if found is None:
            return None
        body, shape, distance, at, normal = found
        return Closest(Body(self, body), BodyShape(self, shape), distance, at, normal)

    def distance(self, a: Body, b: Body) -> BodyDistance:
        """The signed distance of two bodies."""
        return BodyDistance(*self._box.distance(a.id, b.id))

    def _hit(self, found: tuple[Any, ...] | None) -> Hit | None:
        if found is None:
            return None
        body, shape, fraction, point, normal, inside = found
        return Hit(Body(self, body), BodyShape(self, shape), fraction, point, normal, inside)

    # ---- Reports of the last step ----

    @property
    def contacts(self) -> npt.NDArray[Any]:
        """The contact points, an array [n] of

        body_a, body_b, shape_a, shape_b (ids), point [2] (world, m), normal [2] (unit, from A to B), separation (m, negative
        if they overlap), normal_impulse and tangent_impulse (N s, in the whole step), feature.
        """
        return self._box.contacts()

    @property
    def events(self) -> SimpleNamespace:
        """What happened in the last step, as arrays of ids:

        contact_begins and contact_hits (shape_a, shape_b, point, normal, approach_speed), contact_ends (shape_a, shape_b),
        sensor_begins and sensor_ends (sensor, visitor), broken_joints and fell_asleep.
        """
        return SimpleNamespace(**self._box.events())

    # ---- Snapshots ----

    def save(self) -> bytes:
        """The whole state: a world loaded from it makes the same steps, bit for bit. C++ reads it too."""
        return self._box.save()

    @staticmethod
    def load(snapshot: bytes) -> World:
        """The world of a snapshot. Raises SnapshotError."""
        return World._of(_tumble.World.load(snapshot), False)

    def copy(self) -> World:
        """A world in the same state, without the timeline if it is that of a run."""
        return World.load(self.save())

    def __reduce__(self) -> tuple[Any, ...]:
        return World.load, (self.save(),)

    def __copy__(self) -> World:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> World:
        return self.copy()

    def audit(self) -> None:
        """Checks all invariants of the world, for a defect of this library."""
        self._box.audit()

    # ---- Pictures ----

    def render(self, width: int = 640, height: int = 360, *, center: Vector | None = None,
               view_height: float | None = None, overlay: Sequence[str] = ()) -> npt.NDArray[np.uint8]:  # fmt: skip
        """A frame as an array [height, width, 4] of red, green, blue and alpha, top row first: see `tumble.render`."""
        from tumble.rendering import render

        return render(self, width, height, center=center, view_height=view_height, overlay=overlay)

    def _repr_png_(self) -> bytes:
        from tumble.rendering import png_bytes

        return png_bytes(self.render())

    def __iter__(self) -> Iterator[Body]:
        return iter(self.bodies)

    def __len__(self) -> int:
        return int(self._box.counts()[0])

    def __bool__(self) -> bool:
        return True


def _filter(exclude: Body | None, mask: int | None, sensors: bool) -> dict[str, Any]:
    members: dict[str, Any] = {"sensors": sensors}
    if exclude is not None:
        members["exclude"] = exclude.id
    if mask is not None:
        members["filter"] = {"mask": mask}
    return members


def _wrapped(angle: float) -> float:
    return float((angle + np.pi) % (2.0 * np.pi) - np.pi)


def _to_local(body: Body, point: tuple[float, float]) -> tuple[float, float]:
    x, y = body.position
    c, s = np.cos(body.angle), np.sin(body.angle)
    dx, dy = point[0] - x, point[1] - y
    return float(c * dx + s * dy), float(c * dy - s * dx)


def _to_world(body: Body, point: tuple[float, float]) -> tuple[float, float]:
    x, y = body.position
    c, s = np.cos(body.angle), np.sin(body.angle)
    return float(x + c * point[0] - s * point[1]), float(y + s * point[0] + c * point[1])
