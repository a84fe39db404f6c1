"""Wrong use names the argument, and says what to do."""

import re

import numpy as np
import pytest

import tumble
import tumble.env
from tumble.joints import KINDS

WORLD = tumble.World()
GROUND = WORLD.add_body("static", shapes=[tumble.box(20, 1)], position=(0, -0.5))
BALL = WORLD.add_body(shapes=[tumble.circle(0.5)], position=(0, 3))


def started(name):
    env = tumble.env.make(name)
    env.reset(seed=1)
    return env


CALLS = [
    (lambda: WORLD.step(1 / 60), TypeError, "count must be a whole number .* a step lasts 1 / steps_per_second"),
    (lambda: WORLD.step(2**70), ValueError, "count must be a whole number"),
    (lambda: WORLD.add_body(shapes=tumble.circle(1)), TypeError, "shapes must be a list of shapes"),
    (lambda: WORLD.add_body(shapes=[(1, 1)]), TypeError, r"shapes must be a Shape, .* got \(1, 1\)"),
    (lambda: WORLD.add_body(angle="90"), TypeError, "angle must be a number, got '90'"),
    (lambda: WORLD.add_body(angle=np.nan), ValueError, "angle must be finite, got nan"),
    (lambda: setattr(BALL, "angle", np.inf), ValueError, "angle must be finite, got inf"),
    (lambda: WORLD.add_body(position="12"), TypeError, "position must be two numbers, got '12'"),
    (lambda: WORLD.add_body(position=("1", "2")), TypeError, "position must be two numbers"),
    (lambda: WORLD.add_body(user_data="ball"), TypeError, "user_data must be a whole number .* dictionary"),
    (lambda: setattr(BALL, "user_data", None), TypeError, "user_data must be a whole number"),
    (lambda: setattr(BALL.shapes[0], "user_data", -1), ValueError, "user_data must be a whole number"),
    (lambda: setattr(WORLD, "gravtiy", (0, 0)), AttributeError, "gravtiy"),
    (lambda: WORLD.add_body(angular_velocity="3"), TypeError, "angular_velocity must be a number"),
    (lambda: WORLD.add_body(mass="3"), TypeError, "mass must be a number"),
    (lambda: GROUND.add_chain([(0, 0), (1, 0)], loop="no"), TypeError, "loop must be True or False"),
    (lambda: BALL.add_shape("circle"), TypeError, "shape must be a Shape, .* got 'circle'"),
    (lambda: BALL.apply_torque("3"), TypeError, "torque must be a number"),
    (lambda: tumble.circle("1"), TypeError, "radius must be a number, got '1'"),
    (lambda: tumble.polygon([(0, 0), (1, 0, 0)]), ValueError, "points must be an array of numbers"),
    (lambda: WORLD.cast_rays((0, 0), np.ones((2, 2), complex)), TypeError, "translations must be an array .* complex"),
    (lambda: WORLD.overlap((0, 0)), TypeError, "shape must be a Shape"),
    (lambda: tumble.distance(GROUND, BALL), TypeError, "a must be a Shape, .* World.distance takes bodies"),
    (lambda: WORLD.add_joint("hinge", GROUND, BALL), ValueError, "kind must be one of revolute, .* got 'hinge'"),
    (lambda: WORLD.add_joint("revolute", GROUND, BALL, limits=1), TypeError, r"limits \(lower, upper\) must be two numbers"),
    (lambda: WORLD.add_joint("revolute", GROUND, BALL, motor=3), TypeError, r"motor \(speed, largest torque or force\)"),
    (lambda: WORLD.add_joint("distance", GROUND, BALL, anchor_a=("a", 0)), TypeError, "anchor_a must be two numbers"),
    (lambda: WORLD.add_joint("gear", GROUND, BALL), TypeError, "a gear joint needs joint_a and joint_b"),
    (lambda: WORLD.add_joint("revolute", GROUND, BALL, limit=(0, 1)), TypeError, "has no 'limit': did you mean 'limits'"),
    (lambda: WORLD.add_joint("revolute", GROUND, BALL, ancor=(0, 1)), TypeError, "has no 'ancor': did you mean 'anchor'"),
    (lambda: WORLD.add_joint("filter", GROUND, BALL, motor=(0, 1)), TypeError, "(?!.*anchor)filter joint has no 'motor': expected one of: "),
    (lambda: WORLD.add_body("static", mass=3), ValueError, "a static body has no mass: leave mass out"),
    (lambda: tumble.Run.load(3), tumble.SnapshotError, "saved must be what Run.save returns"),
    (lambda: tumble.Run.load(("{}", 1, b"")), tumble.SnapshotError, "saved must be what Run.save returns"),
    (lambda: tumble.Run.load(("garbage", b"", b"")), tumble.SceneError, "syntax error"),
    (lambda: WORLD.add_joint("mouse", GROUND, BALL), TypeError, "a mouse joint needs max_force"),
    (lambda: WORLD.add_joint("motor", GROUND, BALL), TypeError, "a motor joint needs max_force .* or max_torque"),
    (lambda: WORLD.render("640"), TypeError, "width must be a whole number from 16 to 8192, got '640'"),
    (lambda: WORLD.render(theme=3), TypeError, "theme must be a string, got 3"),
    (lambda: setattr(WORLD, "threads", 1.5), TypeError, "threads must be a whole number"),
    (lambda: setattr(BALL, "awake", "no"), TypeError, "awake must be True or False, got 'no'"),
    (lambda: BALL.lock(x="a"), TypeError, "x must be True or False"),
    (lambda: tumble.render(3), TypeError, "must be a world or a run, got 3"),
    (lambda: tumble.fitted_camera(BALL.shapes), TypeError, "must be a world or a run"),
    (lambda: tumble.fitted_camera(WORLD, "wide"), TypeError, "aspect_ratio must be a number"),
    (lambda: tumble.Scene().start().value(3), TypeError, "expression must be a string, got 3"),
    (lambda: tumble.Scene.parse({"bodies": []}), TypeError, "text must be a string"),
    (lambda: tumble.Scene.load("tray.json", set="/world/duration=3"), TypeError, "set must be a list of overrides"),
    (lambda: tumble.Scene.load("tray.json", seed="a"), TypeError, "seed must be a whole number"),
    (lambda: tumble.World.load("abc"), TypeError, "snapshot must be bytes"),
    (lambda: tumble.step_all(WORLD), TypeError, "worlds must be a list of worlds or runs"),
    (lambda: tumble.step_all(3), TypeError, "worlds must be a list of worlds or runs"),
    (lambda: tumble.step_all([WORLD], threads=1.5), TypeError, "threads must be a whole number"),
    (lambda: tumble.step_all([BALL]), TypeError, "worlds must be worlds or runs"),
    (lambda: tumble.Scene("tray.json"), TypeError, "Scene.load reads a file"),
    (lambda: tumble.Video("ball.mp4", fps=0), ValueError, "fps must be finite and above 0"),
    (lambda: tumble.env.make("cart_pole").reset(seed="a"), TypeError, "seed must be a whole number .* got 'a'"),
    (lambda: tumble.env.make_vector("cart_pole", 2.5), TypeError, "count must be a whole number from 1 .* got 2.5"),
    (lambda: tumble.env.make_vector("cart_pole", 2, threads="all"), TypeError, "threads must be a whole number from 1"),
    (lambda: started("cart_pole").step(0.5), ValueError, "action must be an index of 2 choices, got 0.5"),
    (lambda: started("pusher").step(0), ValueError, r"action must have the shape \(2,\), got 0"),
    (lambda: tumble.env.make("cart_pole").step(0), RuntimeError, r"no episode is going on: call reset\(\)"),
]  # fmt: skip


@pytest.mark.parametrize("call, error, message", CALLS)
def test_wrong_use_says_what_to_do(call, error, message):
    before = WORLD.save()
    with pytest.raises(error) as caught:
        call()
    assert re.search(message, str(caught.value)) and "incompatible function arguments" not in str(caught.value)
    assert WORLD.save() == before


def test_what_is_destroyed_can_be_looked_for():
    world = WORLD.copy()
    world.step(60)
    ball = world.bodies[1]
    shape = ball.shapes[0]
    assert world.find_body(ball.id) == ball and world.find_shape(shape.id) == shape
    ball.destroy()
    world.step()
    (ended,) = world.events.contact_ends
    assert ended["shape_b"] == shape.id and world.find_shape(ended["shape_b"]) is None
    assert world.find_body(ball.id) is None
    with pytest.raises(TypeError):
        world.find_shape("1")


def test_a_body_takes_a_mass_and_turns():
    body = WORLD.copy().add_body(shapes=[tumble.box(1, 2)], mass=6)
    assert body.mass == 6 and body.inertia == pytest.approx(6 * (1 + 4) / 12)


def test_scenes_take_numbers_of_numpy():
    scene = tumble.Scene({"bodies": [{"name": "ball", "position": np.array([1.5, 2]), "angle": np.float32(90)}]})
    assert scene.start().bodies["ball"].position == (1.5, 2)
    assert scene == scene.copy()
    assert scene.copy().to_json() == tumble.Scene({"bodies": [{"name": "ball", "position": [1.5, 2], "angle": 90}]}).to_json()


def test_help_lists_the_members_that_each_kind_of_joint_has():
    world = tumble.World()
    a, b = (world.add_body(shapes=[tumble.circle(1)]) for _ in range(2))
    listed = dict(re.findall(r"^ *- (\w+): (.*)$", tumble.World.add_joint.__doc__, re.MULTILINE))
    assert set(listed) == set(KINDS)
    hinges = [world.add_joint("revolute", world.add_body("static"), body) for body in (a, b)]
    shared = {"body_a", "body_b", "anchor_a", "anchor_b", "break_force", "break_torque", "collide_connected", "user_data"}
    for kind in KINDS:
        bodies = {"joint_a": hinges[0], "joint_b": hinges[1]} if kind == "gear" else {"body_a": a, "body_b": b}
        force = {"max_force": 1} if kind in ("mouse", "motor") else {}
        joint = world.add_joint(kind, anchor_a=(0, 0), anchor_b=(2, 0), **bodies, **force) if kind == "distance" else (
            world.add_joint(kind, **bodies, **force))  # fmt: skip
        assert set(re.findall(r"`(\w+)`", listed[kind])) == joint.definition.keys() - shared, kind
