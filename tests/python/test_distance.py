"""Distances: single queries, batches and traces."""

import numpy as np
import pytest

import tumble


def test_a_distance_has_bounds_points_and_a_proof():
    result = tumble.distance(tumble.circle(1), tumble.box(2, 2), position_b=(4, 0))
    assert result.status == "separated" and result.distance == 2 and float(result) == 2
    assert result.lower <= 2 <= result.upper
    assert result.point_a == (1, 0) and result.point_b == (3, 0) and result.normal == (1, 0)
    assert len(result.certificate.pairs) >= 1
    assert tumble.distance(tumble.box(2, 2), tumble.box(2, 2), position_b=(1, 0)).distance == -1
    assert tumble.distance(tumble.box(2, 2), tumble.box(2, 2), position_b=(np.nan, 0)).status == "invalid"


def test_a_batch_has_the_bits_of_single_queries():
    random = np.random.default_rng(1)
    n = 1000
    shapes = [tumble.polygon(random.normal(size=(6, 2)), radius=0.1) for _ in range(n)]
    other = tumble.box(1, 2)
    poses = np.column_stack([random.uniform(-3, 3, (n, 2)), random.uniform(-3, 3, n)])
    batch = tumble.distances(shapes, poses, other, (0.5, 0, 1))
    assert batch.shape == (n,)
    for i in range(n):
        single = tumble.distance(shapes[i], other, position_a=poses[i, :2], angle_a=poses[i, 2],
                                 position_b=(0.5, 0), angle_b=1)  # fmt: skip
        assert batch["distance"][i] == single.distance
        assert batch["lower"][i] == single.lower
        assert tuple(batch["point_a"][i]) == single.point_a
        assert tumble.STATUS[batch["status"][i]] == single.status


def test_poses_may_have_cosine_and_sine_and_one_row_for_all():
    a, b = tumble.box(1, 1), tumble.circle(0.5)
    xs = np.linspace(2, 5, 50)
    poses = np.column_stack([xs, 0 * xs, 0 * xs + 1, 0 * xs])
    assert np.allclose(tumble.distances(a, (0, 0, 1, 0), b, poses)["distance"], xs - 1)
    assert len(tumble.distances(a, np.zeros((0, 3)), b, (0, 0, 0))) == 0
    assert len(tumble.distances([a, a], (0, 0, 0), b, (0, 0, 0))) == 2


def test_wrong_arrays_raise():
    a = tumble.box(1, 1)
    for poses in (np.zeros((3, 2)), np.zeros((2, 2, 3)), np.zeros(5)):
        with pytest.raises(ValueError):
            tumble.distances(a, poses, a, (0, 0, 0))
    with pytest.raises(ValueError, match="one length"):
        tumble.distances(a, np.zeros((3, 3)), a, np.zeros((2, 3)))
    with pytest.raises(ValueError):
        tumble.distances(a, [["x", 0, 0]], a, (0, 0, 0))
    for shapes in (["box"], [None], [a, None], [3], 3, None, [tumble.World()]):
        with pytest.raises(TypeError):
            tumble.distances(shapes, np.zeros((1, 3)), a, (0, 0, 0))
        with pytest.raises(TypeError):
            tumble.distances(a, np.zeros((1, 3)), shapes, (0, 0, 0))
    with pytest.raises(ValueError, match="one length"):
        tumble.distances([a, a], np.zeros((3, 3)), a, (0, 0, 0))


class Made:
    """A sequence that makes its shapes when they are asked for, and may have another length than it says."""

    def __init__(self, count, extra=0):
        self.count, self.extra = count, extra

    def __len__(self):
        return self.count

    def __getitem__(self, i):
        if i >= self.count + self.extra:
            raise IndexError
        return tumble.polygon([(0, 0), (1 + i, 0), (1 + i, 1), (0, 1)])


def test_shapes_that_are_made_on_the_fly_live_as_long_as_the_query():
    """Box i ends at x = 1 + i: the gap to a point at x = 10 is 9 - i."""
    n = 9
    batch = tumble.distances(Made(n), (0, 0, 0), tumble.circle(0), (10, 0.5, 0))
    assert batch["distance"].tolist() == [9 - i for i in range(n)]
    for extra in (-1, 1):
        with pytest.raises(ValueError, match="must have 1 or 9 shapes"):
            tumble.distances(Made(n, extra), (0, 0, 0), tumble.circle(0), (10, 0, 0))


def test_a_trace_lists_the_iterations():
    trace = tumble.trace_distance(tumble.circle(1), tumble.box(2, 2), position_b=(4, 1))
    assert trace.result.distance == 2
    assert trace.steps[-1]["lower"] <= trace.steps[-1]["upper"]
    assert trace.svg.startswith("<svg") or trace.svg.startswith("<?xml")
