"""Every environment that comes with tumble is solved by a matrix that the cross-entropy method finds."""

import os

import numpy as np
import pytest

import solving
import tumble.env

#: The arguments of the search, the score of a solution (at least in the mean of 32 new episodes), and the score that
#: always acting in the middle of the range does not reach.
RECIPES = {
    "acrobot": (dict(policy=solving.as_choice, seed=3, count=96, generations=10, episodes=2), -100, -150),
    "car_racing": (dict(count=32, generations=12, episodes=2, inputs="tilt turning speed rise grips"), 9, 0),
    "juggling": (dict(count=32, generations=6, episodes=2, inputs="next_x"), 300, 150),
    "lunar_lander": (dict(seed=2, count=64, generations=20, episodes=3,
                          inputs="x height x_speed y_speed tilt turning"), 90, -100),
    "pusher": (dict(count=128, generations=20, episodes=4, inputs="to_crate_x to_crate_y to_goal_x to_goal_y"), 18, 0),
    "stacking": (dict(seed=16, count=160, generations=20, episodes=8, inputs="base_x across x y"), 11, 0),
}  # fmt: skip


#: Searches that take minutes. A walker that reaches 6 m has made a dozen steps.
LONG = {
    "bipedal_walker": (dict(count=96, generations=60, spread=0.7,
                            inputs="beat_sin beat_cos tilt turning left_hip left_knee right_hip right_knee"), 6, 0),
}  # fmt: skip


def solve(name):
    options, *limits = {**RECIPES, **LONG}[name]
    options = {**options, "inputs": options["inputs"].split()} if "inputs" in options else options
    policy = options.get("policy", solving.linear)
    return solving.cross_entropy(name, **options), policy, *limits


@pytest.mark.parametrize("name", [*RECIPES, *(LONG if "TUMBLE_LONG" in os.environ else ())])
def test_an_environment_is_solved(name):
    weights, policy, solved, idle = solve(name)
    assert solving.scores(name, weights, policy=policy).mean() >= solved
    assert solving.scores(name, np.zeros_like(weights), policy=policy).mean() <= idle


def test_a_search_repeats_with_its_seed():
    first, again, other = (solving.cross_entropy("juggling", seed=seed, count=16, generations=2) for seed in (5, 5, 6))
    assert np.array_equal(first, again) and not np.array_equal(first, other)


def test_all_environments_are_tried():
    assert set(tumble.env.names()) == {*RECIPES, *LONG, "cart_pole"}


def test_ten_thousand_episodes_repeat_bit_for_bit():
    """Cart-poles that are pushed at random: as many episodes twice, on one thread and on two."""

    def run(threads):
        envs = tumble.env.make_vector("cart_pole", 500, threads=threads)
        envs.reset(seed=11)
        random, episodes, seen = np.random.default_rng(3), 0, []
        while episodes < 10000:
            observations, rewards, terminated, truncated, _ = envs.step(random.integers(0, 2, 500))
            episodes += int((terminated | truncated).sum())
            seen.append((observations.tobytes(), envs.final_observations.tobytes(), rewards.tobytes()))
        return seen

    assert run(1) == run(2)
