"""What environments measure and change: rays, contact forces, random numbers of the scene."""

import numpy as np
import pytest

import tumble
import tumble.env

CIRCLE = {"circle": {"radius": 0.5}}


def observed(bodies, observations, *, world=None, steps=0, count=1, **env):
    """The observations of the first world after some steps."""
    scene = tumble.Scene({"world": world or {"gravity": [0, 0]}, "bodies": bodies,
                          "custom": {"env": {"observations": observations, **env}}})  # fmt: skip
    envs = tumble.env.VectorEnv(scene, count, threads=1)
    rows = envs.reset(seed=1)[0]
    for _ in range(steps):
        rows = envs.step(np.zeros((count, 0)))[0]
    return rows[0]


def test_rays_measure_the_free_part():
    """A wall at x = 3, a post from (0, 2) upwards, and the eye's own circle, which rays leave out."""
    bodies = [{"name": "wall", "type": "static", "position": [4, 0], "shapes": [{"box": {"size": [2, 10]}}]},
              {"name": "post", "type": "static", "position": [0, 3], "shapes": [{"box": {"size": [0.5, 2]}, "filter": {"category": 4}}]},
              {"name": "eye", "shapes": [CIRCLE]}]  # fmt: skip
    ray = {"rays": "eye", "length": 4}
    assert observed(bodies, [{**ray, "angles": [0, 0]}]).tolist() == [0.75]
    assert observed(bodies, [{**ray, "angles": [0, 90], "count": 4}]) == pytest.approx([0.75, 0.75 / np.cos(np.pi / 6), 1, 0.5], rel=1e-7)
    assert observed(bodies, [{**ray, "angles": [180, 180]}]).tolist() == [1]
    assert observed(bodies, [{**ray, "angles": [0, 0], "point": [1, 0]}]).tolist() == [0.5]
    assert observed(bodies, [{**ray, "angles": [0, 0], "scale": 4, "offset": 0.25}]).tolist() == [2]
    # Rays see the categories of their mask, and turn with the body if they are told to.
    upwards = {**ray, "angles": [90, 90]}
    assert observed(bodies, [{**upwards, "mask": 4}, {**upwards, "mask": 1}]) == pytest.approx([0.5, 1], rel=1e-7)
    turned = [*bodies[:2], {**bodies[2], "angle": 90}]
    assert observed(turned, [{**ray, "angles": [0, 0]}, {**ray, "angles": [0, 0], "turns": True}]) == pytest.approx([0.75, 0.5], rel=1e-6)


def test_a_contact_force_is_the_weight_that_rests():
    """A box of 2 kg under one of 1 kg: 10 N between them, 30 N on the ground, 40 N on the lower one in all."""
    bodies = [{"name": "ground", "type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [9, 1]}}]},
              {"name": "low", "position": [0, 0.5], "shapes": [{"box": {"size": [2, 1]}}]},
              {"name": "high", "position": [0, 1.5], "shapes": [{"box": {"size": [1, 1]}}]}]  # fmt: skip
    seen = [{"contact_force": pair} for pair in (["low", "high"], ["high", "low"], ["ground", "low"], "low", ["ground", "high"])]
    forces = observed(bodies, seen, world={"sleeping": False}, steps=120)
    assert forces == pytest.approx([10, 10, 30, 40, 0], rel=1e-3)


def test_each_episode_draws_the_random_numbers_of_its_scene():
    scene = tumble.Scene({
        "world": {"gravity": [0, {"uniform": [-12, -8]}], "steps_per_second": 100},
        "bodies": [{"name": "base", "type": "static"},
                   {"name": "ball", "shapes": [{"circle": {"radius": {"choice": [0.25, 0.5]}}}], "position": [0, 5]}],
        "joints": [{"name": "rail", "type": "prismatic", "bodies": ["base", "ball"], "anchor": [0, 5], "axis": [1, 0],
                    "motor": {"speed": {"uniform": [1, 2]}, "max_force": 1000}},],
        "custom": {"env": {"steps": 5, "observations": [{"value": "ball.mass"}, {"joint": "rail", "of": "speed"}]}}})  # fmt: skip

    def episodes(count, threads, episodes=3):
        envs = tumble.env.VectorEnv(scene, count, seed=4, threads=threads)
        rows, gravities = [envs.reset()[0].copy()], [[envs.world(i).gravity[1] for i in range(count)]]
        for step in range(5 * (episodes - 1)):
            observations, *_, infos = envs.step(np.zeros((count, 0)))
            if infos:
                rows += [infos["final_obs"].copy(), observations.copy()]
                gravities.append([envs.world(i).gravity[1] for i in range(count)])
        return np.array(rows), np.array(gravities)

    rows, gravities = episodes(40, 2)
    assert len(np.unique(gravities)) == gravities.size == 120 and gravities.min() > -12 and gravities.max() < -8
    assert gravities.mean() == pytest.approx(-10, abs=4 * (4 / np.sqrt(12)) / np.sqrt(120))  # 4 standard errors
    area = np.pi * np.float32([0.0625, 0.25])
    masses = rows[..., 0]
    assert np.isclose(masses[..., None], area, rtol=1e-5).any(axis=-1).all()
    assert 0.3 < np.isclose(masses, area[0], rtol=1e-5).mean() < 0.7
    speeds = rows[1::2, :, 1]  # at the ends of episodes
    assert speeds.min() > 0.99 and speeds.max() < 2.01 and len(np.unique(speeds)) > 70
    again, _ = episodes(7, 1)
    assert np.array_equal(rows[:, :7], again)


def test_random_numbers_must_not_change_how_many_bodies_there_are():
    scene = tumble.Scene({
        "bodies": [{"name": "ball", "shapes": [CIRCLE], "repeat": {"grid": {"columns": {"uniform": [1, 9]}, "rows": 1, "spacing": [2, 2]}}}],
        "custom": {"env": {"observations": [{"value": "time"}]}}})  # fmt: skip
    envs = tumble.env.VectorEnv(scene, 8)
    with pytest.raises(ValueError, match="change how many bodies"):
        envs.reset()


def test_an_episode_that_draws_a_wrong_number_has_the_error_of_the_scene():
    scene = tumble.Scene({
        "bodies": [{"name": "ball", "shapes": [CIRCLE]}],
        "joints": [{"type": "revolute", "bodies": ["ball", "pin"], "anchor": [0, 0], "limits": [{"uniform": [-9, 0]}, {"uniform": [-3, 9]}]}],
        "custom": {"env": {"observations": [{"value": "time"}]}}})  # fmt: skip
    scene.data["bodies"].append({"name": "pin", "type": "static"})
    with pytest.raises(tumble.SceneError, match="limits"):
        tumble.env.VectorEnv(scene, 64).reset()
