"""Steps on several threads and of many worlds, and worlds that diverge."""

import contextlib
import subprocess
import sys
import threading

import numpy as np
import pytest

import tumble


def make_world(**options):
    world = tumble.World(**options)
    world.add_body("static", shapes=[tumble.box(40, 1)], position=(0, -0.5))
    return world


def test_other_threads_run_during_a_step_but_may_not_touch_the_world():
    world = make_world()
    for i in range(400):
        world.add_body(shapes=[tumble.box(0.5, 0.5)], position=(0.6 * (i % 20), 1 + 0.6 * (i // 20)))
    errors, counted = [], 0
    thread = threading.Thread(target=lambda: world.step(200))
    thread.start()
    while thread.is_alive():
        counted += 1
        try:
            world.positions
        except RuntimeError as error:
            errors.append(str(error))
    thread.join()
    assert counted > 10
    assert set(errors) == {"another thread is stepping this world"}
    assert world.step_count == 200


def test_views_show_the_state_in_which_a_world_diverged():
    world = tumble.World(gravity=(0, 0), steps_per_second=0.125)
    other = world.add_body(shapes=[tumble.circle(1)], velocity=(1, 0))
    body = world.add_body("kinematic", position=(9, 9))
    world.step(2)
    positions, velocities = world.positions, world.velocities
    assert positions[0, 0] == 16
    body.velocity = (3e38, 0)  # more than a float can represent after 8 s
    with pytest.raises(tumble.SimulationDiverged) as caught:
        world.step(3)
    assert caught.value.body == body.id and caught.value.step == 3
    assert positions[0, 0] == other.position[0] == 24
    assert np.array_equal(positions[1], body.position, equal_nan=True) and not np.isfinite(positions[1]).all()
    assert np.array_equal(velocities[1], np.float32(body.velocity), equal_nan=True)
    with pytest.raises(tumble.SimulationDiverged):
        world.step()


def test_threads_make_the_same_steps():
    def pile(threads):
        world = make_world(threads=threads)
        for i in range(900):
            world.add_body(shapes=[tumble.box(0.5, 0.5)], position=(0.6 * (i % 30), 1 + 0.6 * (i // 30)))
        return world

    one, two = pile(1), pile(2)
    assert (one.threads, two.threads) == (1, 2)
    one.step(20)
    two.step(20)
    assert one.state_hash == two.state_hash
    assert two.copy().threads == 1
    two.threads = 1
    assert two.threads == 1 and two.copy().threads == 1


def test_threads_that_cannot_start_raise():
    """The stacks of a thousand threads need more memory than the process may have."""
    code = """
import resource, tumble
worlds = [tumble.World() for _ in range(1000)]
size = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + 2**29, size + 2**29))
try:
    tumble.step_all(worlds, threads=1000)
except RuntimeError:
    tumble.step_all(worlds, threads=1)
    print(worlds[-1].step_count)
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert (run.returncode, run.stdout) == (0, "1\n"), run.stderr


def test_many_worlds_are_stepped_at_once():
    """Runs among them go on with their timelines; one that diverges does not keep the others from their steps."""
    worlds, twins = ([make_world(gravity=(i, -10)) for i in range(6)] for _ in range(2))
    for world in worlds + twins:
        world.add_body(shapes=[tumble.circle(0.5)], position=(0, 4))
    run = tumble.Scene({
        "bodies": [{"name": "ball", "shapes": [{"circle": {"radius": 0.5}}]}], "world": {"gravity": [0, 0]},
        "timeline": [{"at": 0.1, "body": "ball", "velocity": [3, 0]}]}).start()  # fmt: skip
    view = worlds[3].positions
    tumble.step_all([*worlds, run], 60, threads=3)
    for world, twin in zip(worlds, twins):
        twin.step(60)
        assert world.state_hash == twin.state_hash
    assert np.array_equal(view, twins[3].positions)
    assert run.bodies["ball"].position[0] == pytest.approx(2.7, abs=1e-5)
    lost = tumble.World(steps_per_second=0.1)
    lost.add_body("kinematic", velocity=(3e38, 0))
    with pytest.raises(tumble.SimulationDiverged):
        tumble.step_all([lost, *worlds], threads=2)
    assert [world.step_count for world in worlds] == [61] * 6
    with pytest.raises(ValueError, match="twice"):
        tumble.step_all([worlds[0], worlds[0]])
    assert worlds[0].step_count == 61
    tumble.step_all([])


def test_a_shape_as_large_as_a_float_allows_makes_steps_or_diverges():
    world = tumble.World()
    world.add_body(shapes=[tumble.circle(0), tumble.circle(3e38)], position=(1.5, -3.5))
    world.add_body("kinematic", shapes=[tumble.circle(1.75)], position=(-0.5, -2))
    with contextlib.suppress(tumble.SimulationDiverged):
        world.step(3)
