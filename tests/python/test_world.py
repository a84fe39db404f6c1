"""Worlds, bodies, shapes, joints, queries, events and snapshots."""

import copy
import pickle

import numpy as np
import pytest

import tumble


def make_world(**options):
    world = tumble.World(**options)
    world.add_body("static", shapes=[tumble.box(40, 1)], position=(0, -0.5))
    return world


def test_a_ball_falls_as_the_first_example_of_the_page_says():
    world = make_world()
    ball = world.add_body(shapes=[tumble.circle(0.5)], position=(0, 4))
    world.step(120)
    assert ball.position[1] == pytest.approx(0.5, abs=1e-3)
    assert world.time == 2.0
    assert world.step_count == 120


def test_properties_of_a_body_can_be_read_and_set():
    world = tumble.World(gravity=(0, 0))
    body = world.add_body(shapes=[tumble.box(2, 1)], density=3, position=(1, 2), angle=0.5, velocity=(3, 4))
    assert body.type == "dynamic"
    assert body.position == (1, 2)
    assert body.angle == pytest.approx(0.5, abs=1e-7)
    assert body.velocity == (3, 4)
    assert body.mass == pytest.approx(6)
    assert body.inertia == pytest.approx(6 * (4 + 1) / 12)
    body.angular_velocity = 2
    assert body.velocity_at((1, 3)) == (1, 4)  # 1 m above the centre: 2 rad/s to the left
    body.mass = 12
    assert body.inertia == pytest.approx(5)
    body.reset_mass()
    assert body.mass == pytest.approx(6)
    body.position = (7, 8)
    body.user_data = 2**64 - 1
    assert (body.position, body.user_data) == ((7, 8), 2**64 - 1)
    for name in ("bullet", "enabled"):
        setattr(body, name, False)
        assert getattr(body, name) is False
    body.gravity_scale = 0.5
    body.linear_damping = 0.25
    body.angular_damping = 0.75
    assert (body.gravity_scale, body.linear_damping, body.angular_damping) == (0.5, 0.25, 0.75)
    body.type = "kinematic"
    assert body.mass == 0
    assert repr(body) == "<Body 0, kinematic, at (7, 8) m, 1 shape>"
    assert world.body(body.id) == body
    assert {body: 1}[world.bodies[0]] == 1


def test_shapes_have_materials_filters_and_mass():
    world = tumble.World()
    body = world.add_body()
    shape = body.add_shape(tumble.circle(1), density=2, friction=0.1, restitution=0.9, category=4, user_data=3)
    assert body.mass == pytest.approx(2 * np.pi)
    shape.density = 1
    assert body.mass == pytest.approx(np.pi)
    assert (shape.friction, shape.restitution) == pytest.approx((0.1, 0.9))
    assert (shape.body, shape.sensor, shape.user_data) == (body, False, 3)
    assert shape.shape == tumble.circle(1)
    zeros = tumble.circle(1, (-0.0, 0.0))
    assert zeros == tumble.circle(1) and hash(zeros) == hash(tumble.circle(1)) != hash(tumble.circle(1, (1, 0)))
    assert tumble.polygon([(0, 0), (2, 0), (0, 2), (0.5, 0.5)]).vertices.shape == (3, 2)
    assert pickle.loads(pickle.dumps(tumble.box(2, 1, radius=0.1))) == tumble.box(2, 1, radius=0.1)
    shape.remove()
    assert body.shapes == [] and not shape.is_alive
    chain = world.add_body("static").add_chain([(5, 0), (0, 0), (-5, 0)])
    assert len(chain) == 2


def test_joints_report_their_motion_and_take_new_members():
    world = tumble.World(gravity=(0, 0))
    base = world.add_body("static")
    arm = world.add_body(shapes=[tumble.box(2, 0.2)], position=(1, 0), angle=0.3)
    hinge = world.add_joint("revolute", base, arm, anchor=(0, 0), motor=(2, 1000))
    assert hinge.kind == "revolute"
    assert hinge.position == pytest.approx(0, abs=1e-6)  # measured from the poses at creation
    world.step(30)
    assert hinge.speed == pytest.approx(2, rel=1e-3)
    assert hinge.position == pytest.approx(1, rel=1e-2)
    assert hinge.motor == (2, 1000)
    hinge.motor_speed = -1
    world.step(60)
    assert hinge.position == pytest.approx(0, abs=0.02)
    hinge.limits = (-0.1, 0.1)
    world.step(60)
    assert hinge.position == pytest.approx(-0.1, abs=1e-2)
    hinge.motor = None
    with pytest.raises(ValueError, match="no motor"):
        hinge.motor_speed = 1
    rod = world.add_joint("distance", base, arm, anchor_a=(0, 3))
    assert rod.definition["length"] == pytest.approx(np.hypot(arm.position[0], arm.position[1] - 3), rel=1e-6)
    assert rod.position == pytest.approx(rod.definition["length"], rel=1e-6)
    assert {joint.id for joint in arm.joints} == {hinge.id, rod.id}
    rod.destroy()
    assert not rod.is_alive and repr(rod) == "<Joint 1, destroyed>"
    with pytest.raises(TypeError, match="revolute joint has no 'lenght'"):
        world.add_joint("revolute", base, arm, lenght=3)
    with pytest.raises(ValueError, match="kind must be one of revolute, .* got 'hinge'"):
        world.add_joint("hinge", base, arm)


def test_views_show_every_later_step_without_a_copy():
    world = make_world()
    for i in range(10):
        world.add_body(shapes=[tumble.circle(0.2)], position=(i, 3 + i))
    positions, angles = world.positions, world.angles
    velocities, turning = world.velocities, world.angular_velocities
    address = positions.__array_interface__["data"][0]
    for _ in range(300):
        world.step()
        assert world.positions is positions
    assert positions.__array_interface__["data"][0] == address
    assert positions.dtype == np.float64 and positions.shape == (11, 2)
    for i, body in enumerate(world.bodies):
        assert tuple(positions[i]) == body.position
        assert angles[i] == body.angle
        assert tuple(velocities[i]) == body.velocity
        assert turning[i] == body.angular_velocity
    assert not positions.flags.writeable
    with pytest.raises(ValueError):
        positions[0, 0] = 1
    world.bodies[3].position = (50, 50)
    assert tuple(world.positions[3]) == (50, 50)


def test_a_view_survives_spawns_and_its_world():
    world = make_world()
    world.add_body(shapes=[tumble.circle(0.5)], position=(0, 9))
    old = world.positions
    part = world.angles[1:]
    before = old.copy()
    world.add_body(position=(5, 5))
    world.step(10)
    assert np.array_equal(old, before)
    assert world.positions.shape == (3, 2)
    late = world.positions
    del world
    assert late[2, 0] == 5
    assert part.shape == (1,)


def test_contacts_and_events_are_structured_arrays():
    world = make_world()
    ball = world.add_body(shapes=[tumble.circle(0.5)], density=2, position=(0, 1))
    begins = 0
    for _ in range(120):
        world.step()
        begins += len(world.events.contact_begins)
        for hit in world.events.contact_hits:
            assert hit["approach_speed"] > 1
    assert begins == 1
    contacts = world.contacts
    assert len(contacts) == 1
    assert world.body(contacts["body_b"][0]) == ball
    assert tuple(contacts["normal"][0]) == (0, 1)
    # The impulse of a step is the weight times its duration.
    assert contacts["normal_impulse"][0] == pytest.approx(ball.mass * 10 / 60, rel=1e-2)
    assert np.array_equal(ball.contacts, contacts)
    assert world.shape(contacts["shape_b"][0]).body == ball
    sensor = world.add_body("static", position=(5, 0))
    sensor.add_shape(tumble.box(1, 1), sensor=True)
    ball.position = (5, 0.2)
    world.step()
    assert len(world.events.sensor_begins) == 1


def test_queries_find_shapes():
    world = make_world()
    ball = world.add_body(shapes=[tumble.circle(0.5)], position=(0, 4))
    hit = world.cast_ray((0, 10), (0, -20))
    assert hit.body == ball and hit.point == pytest.approx((0, 4.5)) and hit.normal == pytest.approx((0, 1))
    assert hit.fraction == pytest.approx(5.5 / 20)
    assert world.cast_ray((0, 10), (0, -20), exclude=ball).point == pytest.approx((0, 0))
    assert [h.body for h in world.cast_ray_all((0, 10), (0, -20))][0] == ball
    assert world.cast_ray((0, 10), (0, 20)) is None
    rays = world.cast_rays((0, 10), [(0, -20), (0, 20), (3, -20)])
    assert rays["hit"].tolist() == [True, False, True]
    assert rays["fraction"][0] == hit.fraction and rays["fraction"][1] == 1
    assert rays["body"][0] == ball.id
    assert world.closest((0, 5)).distance == pytest.approx(0.5)
    assert world.overlap(tumble.circle(1), (0, 5))[0].body == ball
    assert world.overlap_box((-1, 3), (1, 5))[0].body == ball
    assert world.cast_shape(tumble.circle(0.5), (0, 10), (0, -10)).fraction == pytest.approx(0.5)
    assert world.distance(world.bodies[0], ball).distance == pytest.approx(3.5)


def test_a_world_is_saved_pickled_and_copied_bit_for_bit():
    world = make_world()
    for i in range(20):
        world.add_body(shapes=[tumble.box(0.5, 0.5)], position=(0.1 * i, 1 + i))
    world.step(50)
    twins = [tumble.World.load(world.save()), pickle.loads(pickle.dumps(world)), copy.deepcopy(world), world.copy()]
    world.step(100)
    for twin in twins:
        twin.step(100)
        assert twin.state_hash == world.state_hash
    with pytest.raises(tumble.SnapshotError):
        tumble.World.load(b"nonsense")
    with pytest.raises(tumble.SnapshotError):
        tumble.World.load(world.save()[:-1])


@pytest.mark.parametrize(
    "call",
    [
        lambda body: body.position,
        lambda body: setattr(body, "velocity", (0, 0)),
        lambda body: body.apply_force((1, 0)),
        lambda body: body.add_shape(tumble.circle(1)),
        lambda body: body.shapes,
        lambda body: body.destroy(),
        lambda body: body.mass,
        lambda body: body.contacts,
    ],
)
def test_a_destroyed_body_raises_and_does_not_crash(call):
    world = make_world()
    body = world.add_body(shapes=[tumble.circle(1)])
    body.destroy()
    assert not body.is_alive and repr(body) == "<Body 1, destroyed>"
    with pytest.raises(ValueError, match="body id is stale"):
        call(body)


@pytest.mark.parametrize("number", [float("nan"), float("inf")])
def test_numbers_that_are_not_finite_raise(number):
    world = make_world()
    body = world.add_body(shapes=[tumble.circle(1)])
    before = world.save()
    for call in (
        lambda: setattr(body, "position", (number, 0)),
        lambda: setattr(body, "velocity", (number, 0)),
        lambda: body.apply_impulse((number, 0)),
        lambda: tumble.circle(number),
        lambda: world.cast_ray((number, 0), (1, 0)),
        lambda: setattr(world, "gravity", (0, number)),
    ):
        with pytest.raises(ValueError):
            call()
    assert world.save() == before


def test_wrong_types_and_shapes_raise():
    world = make_world()
    body = world.add_body()
    for call in (
        lambda: setattr(body, "position", 3),
        lambda: setattr(body, "position", (1, 2, 3)),
        lambda: setattr(body, "velocity", "ab"),
        lambda: body.add_shape("circle"),
        lambda: tumble.World(gravity=None),
        lambda: tumble.World(wind=3),
        lambda: world.add_joint("revolute", body),
        lambda: world.add_joint("revolute", body, 3),
        lambda: world.add_joint("gear", joint_a=body, joint_b=3),
        lambda: world.cast_ray((0, 0), (1, 0), exclude=5),
        lambda: world.distance(1, 2),
        lambda: world.distance(body, None),
        lambda: world.body(1.5),
        lambda: world.body("1"),
        lambda: body.add_shape(tumble.circle(1), sensor="yes"),
        lambda: body.add_shape(tumble.circle(1), group=2**40),
        lambda: world.cast_ray((0, 0), (1, 0), mask=-1),
        lambda: setattr(world, "threads", "two"),
        lambda: tumble.step_all([world, 3]),
    ):
        with pytest.raises(TypeError):
            call()
    stranger = tumble.World().add_body(shapes=[tumble.circle(1)])
    for call in (
        lambda: world.add_body("solid"),
        lambda: tumble.polygon([1, 2, 3]),
        lambda: tumble.polygon(np.zeros((3, 3))),
        lambda: tumble.polygon([["a", "b"]]),
        lambda: tumble.circle(-1),
        lambda: world.step(-1),
        lambda: tumble.World(steps_per_second=0),
        lambda: tumble.World(joints="exact"),
        lambda: world.cast_rays(np.zeros((2, 2)), np.zeros((3, 2))),
        lambda: world.add_joint("revolute", body, stranger),
        lambda: world.distance(body, stranger),
        lambda: world.cast_ray((0, 0), (1, 0), exclude=stranger),
        lambda: world.overlap(tumble.circle(1), exclude=stranger),
        lambda: world.body(99),
        lambda: world.body(-1),
        lambda: world.body(2**70),
        lambda: world.shape(99),
        lambda: setattr(body, "position", (10**400, 0)),
        lambda: setattr(world, "threads", -1),
        lambda: tumble.step_all([world], -1),
        lambda: tumble.step_all([world], threads=0),
    ):
        with pytest.raises(ValueError):
            call()


def test_a_body_with_a_wrong_shape_is_not_left_behind():
    world = tumble.World()
    with pytest.raises(ValueError):
        world.add_body(shapes=[tumble.circle(1)], density=-1)
    assert len(world) == 0


def test_motions_can_be_locked_and_filters_changed():
    world = make_world()
    body = world.add_body(position=(0, 3), velocity=(1, 1), angular_velocity=1)
    shape = body.add_shape(tumble.circle(0.5), rolling_resistance=0.25, tangent_speed=0.5, mask=6, group=-2)
    assert body.locks == (False, False, False)
    body.lock(y=True, rotation=True)
    assert body.locks.y and body.locks.rotation and not body.locks.x
    world.step(60)
    assert body.position[1] == 3 and body.angle == 0 and body.position[0] == pytest.approx(1, abs=1e-6)
    assert (body.allow_sleep, body.allow_fast_rotation) == (True, False)
    body.allow_sleep, body.allow_fast_rotation = False, True
    assert (body.allow_sleep, body.allow_fast_rotation) == (False, True)
    assert (shape.rolling_resistance, shape.tangent_speed) == (0.25, 0.5)
    shape.rolling_resistance, shape.tangent_speed = 0.5, -1
    assert (shape.rolling_resistance, shape.tangent_speed, shape.friction) == (0.5, -1, pytest.approx(0.6))
    assert shape.filter == (1, 6, -2)
    shape.set_filter(mask=0)
    assert shape.filter == tumble.Filter(category=1, mask=0, group=-2)
    body.lock()
    world.step(240)
    assert body.position[1] < -3  # through the floor
    assert repr(tumble.box(2, 1, radius=0.25)) == "<Shape of 4 vertices, radius 0.25 m, 2 x 1 m>"
    assert repr(tumble.circle(0.5)) == "<Shape of 1 vertex, radius 0.5 m, 1 x 1 m>"


def test_points_of_a_body_are_turned_and_moved():
    body = tumble.World().add_body(shapes=[tumble.circle(1)], position=(3, 1), angle=np.pi / 2)
    assert body.local_to_world((2, 0)) == pytest.approx((3, 3), abs=1e-6)  # rotations are float
    assert body.world_to_local((3, 3)) == pytest.approx((2, 0), abs=1e-6)
    assert body.world_to_local(body.local_to_world((0.5, -0.25))) == pytest.approx((0.5, -0.25), abs=1e-6)
