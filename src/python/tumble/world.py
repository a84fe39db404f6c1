"""Worlds.

Units are m, kg, s and rad; y is up and counter-clockwise is positive.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Iterator, Sequence
from types import SimpleNamespace
from typing import Any

import numpy as np
import numpy.typing as npt

from tumble import _tumble
from tumble.bodies import BODY_TYPES, DYNAMIC, Body
from tumble.body_shapes import BodyShape
from tumble.joints import Joint, new_members
from tumble.parts import counted, index_of
from tumble.queries import Queries
from tumble.shapes import Shape, Vector, finite, number, shape_of, steps_of, user_data_of, vector, whole
from tumble.vectors import Vec2, VectorProperty

_SOLVERS = ("iterative", "direct")
_IMPACTS = ("at_step_end", "in_order")


class World(Queries):
    """A rigid-body simulation in two dimensions with a fixed time step.

    >>> import tumble
    >>> world = tumble.World(gravity=(0, -10))
    >>> ground = world.add_body("static", shapes=[tumble.box(40, 1)], position=(0, -0.5))
    >>> ball = world.add_body(shapes=[tumble.circle(0.5)], position=(0, 4))
    >>> world.step(120)
    >>> round(ball.position[1], 2)
    0.5

    The same calls give the same bits in every run. A world can be pickled and copied; one thread at a time may use it.

    `sleeping`: bodies at rest sleep, which costs nothing. `continuous`: fast bodies do not pass through thin ones. `joints`:
    "iterative", or "direct", which solves all joints at once, so that chains do not open under load. `impacts`: "in_order",
    or "at_step_end", which is faster. `scale`: the size of a typical body, m.
    """

    __slots__ = ("__weakref__", "_box", "_has_scene")

    def __init__(
        self,
        *,
        gravity: Vector = (0.0, -10.0),
        steps_per_second: float = 60.0,
        substeps: int = 4,
        sleeping: bool = True,
        continuous: bool = True,
        joints: str = "iterative",
        impacts: str = "in_order",
        scale: float = 1.0,
        threads: int = 1,
    ) -> None:
        self._has_scene = False
        self._box = _tumble.World(
            {
                "gravity": vector(gravity, "gravity"),
                "steps_per_second": steps_per_second,
                "substeps": substeps,
                "sleeping": sleeping,
                "continuous": continuous,
                "joints": index_of(_SOLVERS, joints, "joints"),
                "impacts": index_of(_IMPACTS, impacts, "impacts"),
                "scale": scale,
            }
        )
        self.threads = threads

    @classmethod
    def _of(cls, box: _tumble.World, has_scene: bool) -> World:
        world = cls.__new__(cls)
        world._box = box
        world._has_scene = has_scene
        return world

    def __repr__(self) -> str:
        bodies, joints, contacts, awake = self._box.counts()
        return (
            f"<World at {self.time:.3f} s: {counted(bodies, 'body')} ({awake} awake), {counted(joints, 'joint')}, "
            f"{counted(contacts, 'contact')}, hash {self.state_hash}>"
        )

    # ---- Stepping ----

    def step(self, count: int = 1) -> None:
        """Makes `count` steps of 1 / steps_per_second, without the GIL. The world of a run applies its timeline too.

        Raises SimulationDiverged if a pose is not finite any more.
        """
        self._box.step(steps_of(count))

    @property
    def time(self) -> float:
        """s."""
        return self._box.time()

    @property
    def step_count(self) -> int:
        """The number of steps made so far."""
        return self._box.step_count()

    @property
    def threads(self) -> int:
        """The threads that make a step; 0: one for each processor. The same steps come of any number."""
        return self._box.threads()

    @threads.setter
    def threads(self, value: int) -> None:
        self._box.set_threads(whole(value, "threads", 0, 2**31 - 1))

    @property
    def dt(self) -> float:
        """The duration of a step, s."""
        return 1.0 / float(self._box.definition()["steps_per_second"])

    def _gravity(self) -> Vec2:
        """m/s^2."""
        return Vec2(*self._box.definition()["gravity"])

    def _set_gravity(self, value: Vector) -> None:
        self._box.set_gravity(vector(value, "gravity"))

    gravity = VectorProperty(_gravity, _set_gravity)

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
        mass: float | None = None,
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
        """Creates a body, with shapes of one material. `Body.add_shape` adds others.

        `type`: "static", "kinematic" or "dynamic". `position` of its origin (m), `angle` (rad), `velocity` of its centre of
        mass (m/s), `angular_velocity` (rad/s). Its mass is that of the shapes by their `density` (kg/m^2), unless `mass`
        (kg) is given, with which a body without shapes does not turn; only dynamic bodies have a mass. `friction` and
        `restitution` are those of `BodyShape`, the other members those of `Body`.
        """
        if isinstance(shapes, Shape) or not isinstance(shapes, Iterable):
            raise TypeError(f"shapes must be a list of shapes, got {shapes!r}")
        outlines = [shape_of(shape, "shapes") for shape in shapes]
        x, y = vector(position, "position")
        twist = vector(velocity, "velocity"), number(angular_velocity, "angular_velocity")
        own_mass = None if mass is None else number(mass, "mass")
        if own_mass is not None and type in BODY_TYPES and type != DYNAMIC:
            raise ValueError(f"a {type} body has no mass: leave mass out, or make the body dynamic")
        id = self._box.create_body(
            {
                "type": index_of(BODY_TYPES, type, "type"),
                "pose": (x, y, finite(angle, "angle")),
                "linear_damping": linear_damping,
                "angular_damping": angular_damping,
                "gravity_scale": gravity_scale,
                "bullet": bullet,
                "allow_sleep": allow_sleep,
                "allow_fast_rotation": allow_fast_rotation,
                "awake": awake,
                "user_data": user_data_of(user_data),
            }
        )
        body = Body(self, id)
        try:
            for outline in outlines:
                body.add_shape(outline, density=density, friction=friction, restitution=restitution)
            if own_mass is not None:
                body.mass = own_mass
            if awake and twist != ((0.0, 0.0), 0.0):
                self._box.set_velocity(id, *twist)
        except BaseException:
            body.destroy()
            raise
        return body

    @property
    def bodies(self) -> list[Body]:
        """In the order of their ids, which is that of `positions`."""
        return [Body(self, int(id)) for id in self._box.ids()]

    def body(self, id: int) -> Body:
        """The body of an id, as contacts have it. ValueError if it is destroyed: see `find_body`."""
        return Body(self, self._known(id, self._box.is_body, "body"))

    def shape(self, id: int) -> BodyShape:
        """The shape of an id, as contacts and events have it. ValueError if it is removed: see `find_shape`."""
        return BodyShape(self, self._known(id, self._box.is_shape, "shape"))

    def find_body(self, id: int) -> Body | None:
        """The body of an id, or None if it is destroyed."""
        return Body(self, int(id)) if self._box.is_body(whole(id, "id", 0, 2**64 - 1)) else None

    def find_shape(self, id: int) -> BodyShape | None:
        """The shape of an id, or None if it is removed or its body destroyed."""
        return BodyShape(self, int(id)) if self._box.is_shape(whole(id, "id", 0, 2**64 - 1)) else None

    @staticmethod
    def _known(id: int, is_alive: Callable[[int], bool], what: str) -> int:
        number = operator.index(id)
        if not 0 <= number < 2**64 or not is_alive(number):
            raise ValueError(f"there is no {what} with the id {id}")
        return number

    def add_joint(self, kind: str, body_a: Body | None = None, body_b: Body | None = None, **members: Any) -> Joint:
        """Creates a joint.

        Kinds, and the members that each has:

        - revolute: `limits` (rad), `motor` (rad/s, N m), `spring`, `reference_angle`
        - prismatic: `axis`, `limits` (m), `motor` (m/s, N), `spring`, `reference_angle`
        - distance: `length`, `limits` (m), `motor` (m/s, N), `spring`
        - weld: `linear_spring`, `angular_spring`, `reference_angle`
        - wheel: `axis` (of the suspension), `limits` (m), `motor` (rad/s, N m: it turns the wheel), `spring`
        - motor: `velocity` and `angular_velocity` of B in A, `max_force`, `max_torque`, `spring`, `reference_angle`
        - mouse: `max_force`, `spring`; `Joint.set_target` moves it
        - pulley: `ground_anchor_a` and `ground_anchor_b` (world), `length`, `ratio`
        - gear: `joint_a` and `joint_b` (revolute or prismatic), `ratio`; no bodies
        - filter: the two bodies do not collide

        `anchor` is a world point (m) for both bodies, or `anchor_a` and `anchor_b` are points in coordinates of each.
        Pairs are `limits` (lower, upper), `motor` (speed, largest torque or force) and `spring` (hertz, damping ratio).
        `axis` is in coordinates of A. All but filter have `break_force`, `break_torque` and `collide_connected`.
        An angle is measured from the poses at creation unless `reference_angle` is given; a rod without `length` keeps
        the present one.
        """
        return Joint(self, self._box.create_joint(kind, new_members(self._box, kind, body_a, body_b, members)))

    @property
    def joints(self) -> list[Joint]:
        """In the order of their ids."""
        return [Joint(self, id) for id in self._box.joints()]

    def _joints_of(self, body: int) -> list[Joint]:
        return [Joint(self, id) for id in self._box.joints_of(body)]

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
        """What happened in the last step, as arrays of ids; after step(count), in the last of these steps:

        contact_begins and contact_hits (shape_a, shape_b, point, normal, approach_speed), contact_ends (shape_a, shape_b),
        sensor_begins and sensor_ends (sensor, visitor), broken_joints and fell_asleep. What ended may be destroyed:
        `find_body` and `find_shape` are None then.
        """
        return SimpleNamespace(**self._box.events())

    # ---- Snapshots ----

    def save(self) -> bytes:
        """The whole state: a world loaded from it makes the same steps, bit for bit. C++ reads it too."""
        return self._box.save()

    @staticmethod
    def load(snapshot: bytes) -> World:
        """The world of a snapshot, as `save` makes it. Raises SnapshotError."""
        if not isinstance(snapshot, bytes):
            raise TypeError(f"snapshot must be bytes, as save() makes them, got {type(snapshot).__name__}")
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
               view_height: float | None = None, overlay: Sequence[str] = (),
               theme: str | None = None) -> npt.NDArray[np.uint8]:  # fmt: skip
        """A frame as an array [height, width, 4] of red, green, blue and alpha, top row first: see `tumble.render`."""
        from tumble.rendering import render

        return render(self, width, height, center=center, view_height=view_height, overlay=overlay, theme=theme)

    def _repr_png_(self) -> bytes:
        from tumble.rendering import png_bytes

        return png_bytes(self.render())

    def __iter__(self) -> Iterator[Body]:
        return iter(self.bodies)

    def __len__(self) -> int:
        return int(self._box.counts()[0])

    def __bool__(self) -> bool:
        return True
