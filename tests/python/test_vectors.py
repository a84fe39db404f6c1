"""Vec2: the arithmetic of positions and velocities, beside tuples and arrays."""

import json
import pickle

import numpy as np
import pytest

import tumble

A = tumble.Vec2(3.0, 4.0)


def test_vectors_add_and_scale():
    assert A + (1, 2) == (1, 2) + A == tumble.Vec2(4, 6)
    assert A - (1, 2) == (2, 2) and (1, 2) - A == (-2, -2)
    assert 2 * A == A * 2 == (6, 8) and A / 2 == (1.5, 2) and -A == (-3, -4)
    assert A.length == 5 and A.x == 3 and A.y == 4
    for result in (A + (1, 2), (1, 2) + A, A - A, 2 * A, A / np.float32(2), np.float64(2) * A, np.int64(2) * A, -A):
        assert isinstance(result, tumble.Vec2) and json.loads(json.dumps(result)) == [*result]


def test_vectors_are_tuples():
    assert A == (3, 4) and hash(A) == hash((3.0, 4.0)) and json.dumps(A) == "[3.0, 4.0]"
    assert pickle.loads(pickle.dumps(A)) == A and [*A] == [3, 4]


def test_arrays_stay_arrays():
    rows = np.ones((3, 2))
    for result, first in ((rows + A, [4, 5]), (A + rows, [4, 5]), (rows - A, [-2, -3]), (A - rows, [2, 3]), (A * rows, [3, 4])):
        assert isinstance(result, np.ndarray) and result.shape == (3, 2) and result[0].tolist() == first


@pytest.mark.parametrize("call", [lambda: A + 1, lambda: A - 1, lambda: A * (1, 2), lambda: A * "x", lambda: A + (1, 2, 3)])
def test_other_operands_raise(call):
    with pytest.raises(TypeError):
        call()


def test_the_package_returns_vectors():
    world = tumble.World()
    ground = world.add_body("static", shapes=[tumble.box(20, 1)], position=(0, -0.5))
    ball = world.add_body(shapes=[tumble.circle(0.5)], position=(0, 0.5), velocity=(3, 0))
    joint = world.add_joint("revolute", ground, ball, anchor=(0, 1))
    hit, near = world.cast_ray((0, 9), (0, -9)), world.closest((0, 9))
    gap = tumble.distance(tumble.circle(1), tumble.circle(1), position_b=(4, 0))
    for vector in (world.gravity, ball.position, ball.velocity, ball.center_of_mass, ball.velocity_at((0, 0)), joint.force,
                   *joint.anchors, hit.point, hit.normal, near.point, near.normal, gap.point_a, gap.normal,
                   world.distance(ground, ball).point_b):  # fmt: skip
        assert isinstance(vector, tumble.Vec2)
    ball.position += (1, 0)
    ball.velocity *= 2
    assert ball.position == (1, 0.5) and ball.velocity == (6, 0)
