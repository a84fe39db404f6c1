"""The ten examples that users of pymunk and Box2D-py start with run, and end as physics says."""

import re
import runpy
from pathlib import Path

import numpy as np
import pytest

PYTHON = Path(__file__).resolve().parents[2] / "src" / "python"
PAGE = (PYTHON / "FROM_PYMUNK.md").read_text()


def run(name):
    return runpy.run_path(str(PYTHON / "examples" / f"{name}.py"))


def test_the_page_lists_all_examples():
    assert set(re.findall(r"\(examples/(\w+)\.py\)", PAGE)) == {path.stem for path in (PYTHON / "examples").glob("*.py")}
    assert len(list((PYTHON / "examples").glob("*.py"))) == 10


def test_hello():
    assert run("hello")["box"].position == pytest.approx((0, 1), abs=0.01)


def test_bouncing_balls():
    end = run("bouncing_balls")
    assert 0 < len(end["balls"]) < 10
    assert all(ball.is_alive and ball.position[1] > -5.3 for ball in end["balls"])


def test_slide_and_pin_joint():
    end = run("slide_and_pin_joint")
    (ax, ay), (bx, by) = end["rope"].anchors
    assert np.hypot(ax - bx, ay - by) <= 0.76 and end["rope"].position <= 0.76
    assert end["ell"].position == pytest.approx((0, 0), abs=0.01)
    assert abs(end["ell"].angle) > 0.1


def test_newtons_cradle():
    """The last ball swings as far as the first was lifted, 2 m sin 0.6, and the others stay."""
    swing = run("newtons_cradle")["swing"]
    assert swing[4] == pytest.approx(2 * np.sin(0.6), rel=0.02)
    assert max(swing[1:4]) < 0.05


def test_pyramid():
    """Twenty boxes of 1 m on each other: the centre of the highest is at 19.5 m."""
    end = run("pyramid")
    assert end["top"] == pytest.approx(19.5, abs=0.1)
    assert not any(body.awake for body in end["world"].bodies if body.type == "dynamic")


def test_bridge():
    end = run("bridge")
    (ax, ay), (bx, by) = end["hinge"].anchors
    assert np.hypot(ax - bx, ay - by) < 0.02
    assert 1 < min(plank.position[1] for plank in end["planks"]) < 4.9


def test_car():
    end = run("car")
    assert end["car"].position[0] > 30
    assert abs(end["car"].angle) < 1


def test_ray_cast():
    end = run("ray_cast")
    assert end["hit"].point == (4, 0) and end["hit"].normal == (-1, 0)
    # The box from 4 m covers atan(1 / 4) of the first quadrant, the circle asin(1 / 5).
    covered = [np.degrees(np.arctan(1 / 4)), np.degrees(np.arcsin(1 / 5))]
    assert int(end["hits"]["hit"].sum()) == sum(int(angle) + 1 for angle in covered)
    assert [shape.body.position for shape in end["inside"]] == [(5, 0)]


def test_breakout():
    """All bricks are hit, and impacts without loss keep the speed."""
    end = run("breakout")
    assert end["destroyed"] == 25
    assert end["speed"] == pytest.approx(np.hypot(2.4, 6), rel=1e-4)


def test_planet():
    """Circles with the speed sqrt(pull / radius) are orbits."""
    assert run("planet")["radii"] == pytest.approx([4, 6, 8], rel=0.03)
