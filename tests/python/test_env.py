"""Environments: the declaration in the scene, one and many worlds, and cart-pole solved."""

import numpy as np
import pytest

import tumble
import tumble.env


def score(weights, envs, seed):
    """The steps that a linear policy survives in each world, at most one episode."""
    observations = envs.reset(seed=seed)
    alive, steps = np.ones(envs.count, bool), np.zeros(envs.count)
    for _ in range(envs.plan.steps):
        actions = (np.einsum("ij,ij->i", observations, weights) > 0).astype(np.int64)
        observations, rewards, terminated, truncated = envs.step(actions)
        steps += alive * rewards
        alive &= ~(terminated | truncated)
        if not alive.any():
            break
    return steps


def test_cart_pole_is_solved_by_the_cross_entropy_method():
    random = np.random.default_rng(1)
    envs = tumble.env.make_vector("cart_pole", 64)
    mean, spread = np.zeros(4), np.ones(4)
    for generation in range(8):
        weights = mean + spread * random.normal(size=(envs.count, 4))
        steps = score(weights, envs, generation)
        best = weights[np.argsort(-steps, kind="stable")[:8]]
        mean, spread = best.mean(axis=0), best.std(axis=0) + 0.05
    final = score(np.tile(mean, (envs.count, 1)), envs, 99)
    assert final.mean() > 475  # the score from which gymnasium's CartPole-v1 counts as solved
    assert score(np.zeros((envs.count, 4)), envs, 99).mean() < 100  # always to the left


def test_an_episode_depends_on_its_seed_alone():
    def run(count, threads):
        envs = tumble.env.make_vector("cart_pole", count, threads=threads)
        envs.reset(seed=7)
        hashes = []
        for step in range(120):
            envs.step(np.full(count, (step // 7) % 2))
            hashes.append(envs.state_hash(1))
        return hashes, envs.observations[1].tolist()

    assert run(2, 1) == run(9, 1) == run(9, 3)


def test_worlds_that_end_are_reset_and_keep_their_last_observation():
    envs = tumble.env.make_vector("cart_pole", 3)
    first = envs.reset(seed=1).copy()
    assert first.shape == (3, 4) and len({tuple(row) for row in first.tolist()}) == 3
    for step in range(1, 500):
        observations, rewards, terminated, truncated = envs.step(np.array([0, 1, step % 2]))
        if terminated.any():
            break
    ended = int(np.argmax(terminated))
    assert abs(envs.final_observations[ended, 2]) > 0.2095 or abs(envs.final_observations[ended, 0]) > 2.4
    assert abs(observations[ended, 2]) < 0.01 and envs.steps[ended] == 0
    assert rewards.tolist() == [1, 1, 1] and not truncated.any()


def test_one_environment_has_the_interface_of_gymnasium():
    env = tumble.env.make("cart_pole", render_mode="rgb_array")
    with pytest.raises(RuntimeError, match="reset"):
        env.step(0)
    first, info = env.reset(seed=5)
    assert first.shape == env.observation_space.shape == (4,) and info == {}
    assert env.action_space.n == 2 and env.action_space.sample() in (0, 1)
    total, terminated = 0.0, False
    while not terminated:
        observation, reward, terminated, truncated, info = env.step(1)
        total += reward
        assert not truncated
    assert 5 < total < 50 and observation.dtype == np.float32
    assert env.render().shape == (400, 600, 3)
    again, _ = env.reset(seed=5)
    assert np.array_equal(first, again)
    assert not np.array_equal(first, env.reset()[0])  # the next episode


@pytest.mark.parametrize(
    ("member", "value", "message"),
    [
        ("reward", "__import__('os')", "there is no '__import__'"),
        ("reward", "x(1)", "there is no 'x'; known are abs"),
        ("reward", "'x'", "may only contain numbers"),
        ("reward", "x.real", "may not contain Attribute"),
        ("reward", "y + 1", "there is no 'y'"),
        ("done", "x >", "not an expression"),
        ("actions", [{"force": "horse"}], "there is no body 'horse'"),
        ("actions", [{"push": "cart"}], "an action needs one of"),
        ("observations", [{"joint": "hinge", "of": "colour"}], "an observation needs"),
        ("random", [{"body": "cart", "of": "mass", "range": [0, 1]}], "random needs of"),
        ("choices", [[1, 2]], "choices must have the shape"),
        ("prize", 1, "has no 'prize'"),
    ],
)
def test_a_wrong_declaration_is_explained(member, value, message):
    scene = tumble.env.scene_of("cart_pole")
    scene.data["custom"]["env"][member] = value
    with pytest.raises(ValueError, match=message):
        tumble.env.TumbleEnv(scene)


def test_wrong_actions_raise():
    envs = tumble.env.make_vector("cart_pole", 3)
    envs.reset()
    for actions in ([0, 1], [0, 1, 2], [0, -1, 0], [0.5, 0, 0]):
        with pytest.raises(ValueError):
            envs.step(actions)
    scene = tumble.env.scene_of("cart_pole")
    del scene.data["custom"]["env"]["choices"]
    envs = tumble.env.VectorEnv(scene, 2)
    envs.reset()
    envs.step([[0.5], [-0.5]])
    for actions in ([0.5, 0.5], [[np.nan], [0]]):
        with pytest.raises(ValueError):
            envs.step(actions)
    with pytest.raises(ValueError, match="no environment 'cartpole'"):
        tumble.env.make("cartpole")
    with pytest.raises(ValueError, match="declares no environment"):
        tumble.env.TumbleEnv(tumble.Scene())


def test_expressions_work_on_arrays():
    expression = tumble.env.Expression("where(a < 1 and not b > 2, -a ** 2, min(a, b))", {"a", "b"}, "test")
    a, b = np.array([0.5, 3.0, 0.5]), np.array([1.0, 2.0, 3.0])
    assert expression({"a": a, "b": b}).tolist() == [-0.25, 2, 0.5]
    chained = tumble.env.Expression("0 < a < 1", {"a"}, "test")
    assert chained({"a": a}).tolist() == [True, False, True]
