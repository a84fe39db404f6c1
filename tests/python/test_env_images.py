"""Images as observations of environments: pixels and masks."""

import numpy as np
import pytest

import tumble
import tumble.env

# 8 pixels a metre; the middle of the image of 64 x 48 pixels is (0, 3). The ball moves at 1 m/s.
SCENE = {
    "world": {"gravity": [0, 0], "steps_per_second": 10},
    "camera": {"center": [0, 3], "height": 6},
    "materials": {"red": {"color": "#f00"}},
    "bodies": [{"name": "floor", "type": "static", "position": [0, 0.5], "shapes": [{"box": {"size": [20, 1]}}]},
               {"name": "ball", "position": [0, 3], "velocity": [1, 0],
                "shapes": [{"circle": {"radius": 0.5}, "material": "red"}]}],
    "custom": {"env": {"observations": [{"name": "x", "body": "ball", "of": "x"}, {"pixels": [64, 48]}, {"mask": [64, 48]}],
                       "done": "x > 0.75", "reward": "x"}},
}  # fmt: skip


def scene(**env):
    data = {**SCENE, "custom": {"env": {**SCENE["custom"]["env"], **env}}}
    return tumble.Scene(data)


def center_of(mask, label):
    rows, columns = np.nonzero(mask == label)
    return columns.mean() + 0.5, rows.mean() + 0.5


def test_pixels_and_masks_show_the_worlds():
    envs = tumble.env.VectorEnv(scene(), 3)
    seen, _ = envs.reset()
    assert seen["state"].shape == (3, 1) and seen["state"].dtype == np.float32
    assert seen["pixels"].shape == (3, 48, 64, 3) and seen["pixels"].dtype == np.uint8
    assert seen["mask"].shape == (3, 48, 64) and seen["mask"].dtype == np.uint16
    labels = envs.plan.labels
    assert labels == {"floor": 1, "ball": 2}
    assert (seen["mask"][:, -8:] == labels["floor"]).all()  # the lowest metre
    assert center_of(seen["mask"][2], labels["ball"]) == pytest.approx((32, 24), abs=1e-9)
    area = (seen["mask"][0] == labels["ball"]).sum()
    assert area == pytest.approx(np.pi * 16, rel=0.1)
    assert seen["pixels"][1, 22, 30].tolist() == [255, 0, 0]
    assert (seen["pixels"][:, :16] == seen["pixels"][0, 0, 0]).all()  # no text, no grid

    for _ in range(5):
        seen = envs.step(np.zeros((3, 0)))[0]
    assert center_of(seen["mask"][1], labels["ball"]) == pytest.approx((32 + 4, 24), abs=1e-6)


def test_an_episode_that_ends_has_a_last_image_and_a_first_one():
    envs = tumble.env.VectorEnv(scene(), 2)
    first = envs.reset()[0]["mask"].copy()
    for _ in range(20):
        seen, _, terminated, *_ = envs.step(np.zeros((2, 0)))
        if terminated.all():
            break
    assert terminated.all() and np.array_equal(seen["mask"], first)
    assert center_of(envs.final_images["mask"][1], 2)[0] == pytest.approx(32 + 8 * 0.8, abs=0.5)
    assert not np.array_equal(envs.final_images["pixels"], envs.images["pixels"])


def test_one_environment_has_a_space_of_its_parts():
    env = tumble.env.TumbleEnv(scene())
    seen, _ = env.reset(seed=1)
    space = env.observation_space
    assert set(seen) == {"state", "pixels", "mask"} and space["pixels"].shape == seen["pixels"].shape == (48, 64, 3)
    assert space.contains(seen) and space.contains(space.sample())
    before = seen["mask"].copy()
    after, *_ = env.step(np.zeros(0, np.float32))
    assert np.array_equal(seen["mask"], before)  # a copy
    terminated = False
    while not terminated:
        after, _, terminated, *_ = env.step(np.zeros(0, np.float32))
    assert after["state"][0] > 0.75 and center_of(after["mask"], 2)[0] > 37
    only = tumble.env.TumbleEnv(scene(observations=[{"mask": [32, 32]}], done="false", reward="0"))
    assert set(only.reset()[0]) == {"mask"}


def test_an_image_may_have_a_camera_of_its_own():
    eyes = [{"mask": [48, 48], "name": "near", "center": [0, 3], "height": 3},
            {"mask": [48, 48], "name": "behind", "follow": "ball", "center": [0, 3], "height": 6},
            {"name": "x", "body": "ball", "of": "x"}]  # fmt: skip
    envs = tumble.env.VectorEnv(scene(observations=eyes), 1)
    seen, _ = envs.reset()
    assert (seen["near"] == 2).sum() == pytest.approx(4 * (seen["behind"] == 2).sum(), rel=0.1)
    for _ in range(5):
        seen = envs.step(np.zeros((1, 0)))[0]
    assert center_of(seen["near"][0], 2) == pytest.approx((24 + 8, 24), abs=1e-6)
    assert center_of(seen["behind"][0], 2) == pytest.approx((24, 24), abs=1e-6)


@pytest.mark.parametrize(("count", "threads"), [(5, 1), (5, 3)])
def test_images_do_not_depend_on_threads(count, threads):
    pusher = tumble.env.scene_of("pusher")
    pusher.data["custom"]["env"]["observations"] += [{"pixels": [64, 64]}, {"mask": [64, 64]}]
    envs = tumble.env.VectorEnv(pusher, count, threads=threads)
    alone = tumble.env.VectorEnv(pusher, count, threads=1)
    envs.reset(seed=3), alone.reset(seed=3)
    actions = np.random.default_rng(1).uniform(-1, 1, (20, count, 2))
    for action in actions:
        seen, expected = envs.step(action)[0], alone.step(action)[0]
        assert all(np.array_equal(seen[name], expected[name]) for name in expected)
    assert len({seen["mask"][i].tobytes() for i in range(count)}) > 1


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ({"pixels": [64]}, "pixels must be two numbers"),
        ({"mask": [8, 64], "name": "small"}, "each 16 to 8192"),
        ({"mask": 64, "name": "square"}, "mask must be two numbers"),
        ({"pixels": [64, 64], "name": "state"}, "cannot be called 'state'"),
        ({"pixels": [64, 64], "name": "mask"}, "cannot be called 'mask'"),
        ({"pixels": [64, 64], "follow": "horse"}, "no body 'horse'"),
        ({"pixels": [64, 64], "name": "far", "height": 0}, "must be above 0"),
    ],
)
def test_a_wrong_image_is_explained(entry, message):
    with pytest.raises(ValueError, match=message):
        tumble.env.TumbleEnv(scene(observations=[{"mask": [64, 48]}, {"name": "x", "body": "ball", "of": "x"}, entry]))
