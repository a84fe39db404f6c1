"""Environments: the declaration in the scene, one and many worlds, and cart-pole solved."""

import os
import time

import numpy as np
import pytest

import tumble
import tumble.env


def score(weights, envs, seed):
    """The steps that a linear policy survives in each world, at most one episode."""
    observations, _ = envs.reset(seed=seed)
    alive, steps = np.ones(envs.count, bool), np.zeros(envs.count)
    for _ in range(envs.plan.steps):
        actions = (np.einsum("ij,ij->i", observations, weights) > 0).astype(np.int64)
        observations, rewards, terminated, truncated, infos = envs.step(actions)
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
    first = envs.reset(seed=1)[0].copy()
    assert first.shape == (3, 4) and len({tuple(row) for row in first.tolist()}) == 3
    for step in range(1, 500):
        observations, rewards, terminated, truncated, infos = envs.step(np.array([0, 1, step % 2]))
        if terminated.any():
            break
    ended = int(np.argmax(terminated))
    last = infos["final_obs"][ended]
    assert abs(last[2]) > 0.2095 or abs(last[0]) > 2.4
    assert np.array_equal(infos["_final_obs"], terminated)
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
        ("reward", "__import__('os')", "there is no function '__import__'"),
        ("reward", "where(x > 1, 1, 0)", "write if"),
        ("reward", "x ** 2", "a power is written"),
        ("reward", "x.real", "there is no body or joint 'x'"),
        ("reward", "angel + 1", "unknown name 'angel'(.|\n)*did you mean 'angle'"),
        ("reward", 1, "reward must be a text"),
        ("done", "x >", "/custom/env/done: expected a value, got the end"),
        ("done", "x", "done must be a condition"),
        ("observations", [{"name": "time", "body": "cart", "of": "x"}], "a value cannot be called 'time'"),
        ("observations", [{"name": "late", "value": "later"}, {"name": "later", "body": "cart", "of": "x"}], "unknown name"),
        ("observations", ["x"], "an observation must be an object"),
        ("observations", "x", "observations must be a list"),
        ("observations", [{"body": "cart"}], "an observation needs 'of'"),
        ("observations", [{"body": "cart", "of": "x", "scal": 2}], "no 'scal'(.|\n)*did you mean 'scale'"),
        ("observations", [{"body": "cart", "of": "x", "scale": "2"}], "scale must be a number"),
        ("observations", [{"body": "cart", "joint": "hinge", "of": "x"}], "an observation needs one of"),
        ("observations", [{"joint": "hinge", "of": "colour"}], "there is no quantity of a joint 'colour'"),
        ("observations", [{"touches": ["cart", "rail", "pole"]}], "touches must be a body, or a list of two"),
        ("observations", [{"touches": ["cart", "hand"]}], "there is no body 'hand'"),
        ("observations", [{"contact_force": "horse"}], "there is no body 'horse'"),
        ("observations", [{"rays": "cart", "count": 0}], "count must be a whole number from 1 to"),
        ("observations", [{"rays": "cart", "count": 2.5}], "count must be a whole number from 1 to"),
        ("observations", [{"rays": "cart", "length": 0}], "length must be above 0"),
        ("steps", -1, "steps must be a whole number from 0"),
        ("frame_skip", 0, "frame_skip must be a whole number from 1"),
        ("actions", [{"force": "horse"}], "there is no body 'horse'"),
        ("actions", [{"force": "crat"}], "did you mean 'cart'"),
        ("actions", [{"push": "cart"}], "an action needs one of"),
        ("actions", [{"force": "cart", "speed": 3}], "an action has no 'speed'"),
        ("actions", [{"force": "cart", "axis": [1]}], "axis must be two numbers"),
        ("actions", [{"motor_effort": "hinge"}], "an action needs 'speed'"),
        ("random", [{"body": "cart", "of": "colour", "range": [0, 1]}], "there is no random quantity 'colour'"),
        ("random", [{"body": "cart", "of": "x"}], "an entry of random needs 'range'"),
        ("choices", [[1, 2]], "choices must have the shape"),
        ("choices", [["left"]], "choices must have the shape"),
        ("prize", 1, "env has no 'prize'"),
        ("observations", [{"name": "x", "value": "1"}, {"name": "x", "value": "2"}], "an observation 'x' already"),
    ],
)
def test_a_wrong_declaration_is_explained(member, value, message):
    scene = tumble.env.scene_of("cart_pole")
    scene.data["custom"]["env"][member] = value
    with pytest.raises(tumble.SceneError, match=message) as caught:
        tumble.env.TumbleEnv(scene)
    assert caught.value.diagnostics[0].pointer.startswith("/custom/env/" + member)


@pytest.mark.parametrize(
    ("entry", "place"),
    [
        ('{"force": "cart", "rang": [-10, 10]}', (6, 24)),  # of the key
        ('{"force": "crat", "range": [-10, 10]}', (6, 16)),  # of the value
        ('{"motor_effort": "hinge"}', (6, 6)),  # of the object
    ],
)
def test_an_error_of_a_declaration_has_its_place_in_the_file(entry, place, tmp_path):
    """With comments, as in a file; and after an edit the place in the new data, which is one line."""
    file = tmp_path / "cart.json"
    file.write_text(f'''{{"format": 1, // a comment
        "bodies": [{{"name": "cart", "shapes": [{{"circle": {{"radius": 1}}}}]}}, {{"name": "base"}}],
        "joints": [{{"name": "hinge", "type": "revolute", "bodies": ["base", "cart"], "anchor": [0, 0]}}],
 "custom": {{"env": {{
  "actions": [
     {entry}]}}}}}}''')
    with pytest.raises(tumble.SceneError) as caught:
        tumble.env.TumbleEnv(file)
    error = caught.value
    assert (error.file, error.line, error.column) == (str(file), *place)
    scene = tumble.Scene.load(file)
    scene.data["custom"]["env"]["steps"] = 10
    with pytest.raises(tumble.SceneError) as caught:
        tumble.env.TumbleEnv(scene)
    assert caught.value.line == 1 and caught.value.file == "cart.json"


def test_an_error_of_an_override_has_its_place_in_the_new_data(tmp_path):
    file = tmp_path / "made.json"
    file.write_text('{"format": 1,\n "custom": {"env": {"reward": "1"}}}')
    with pytest.raises(tumble.SceneError, match="wrong") as caught:
        tumble.env.TumbleEnv(tumble.Scene.load(file, set=['/custom/env/reward="1 + wrong"']))
    assert caught.value.line == 1 and caught.value.file == "made.json"
    file.write_text('{"format": 1,\n "custom": {"env": {"reward": "1 + wrong"}}}')
    with pytest.raises(tumble.SceneError, match="wrong") as caught:
        tumble.env.TumbleEnv(tumble.Scene.load(file, set=["/world/gravity=[0, 0]"]))
    assert (caught.value.line, caught.value.column, caught.value.file) == (2, 36, str(file))


def test_observations_and_ranges_are_rad_and_expressions_degrees():
    scene = tumble.Scene({
        "world": {"gravity": [0, 0]},
        "bodies": [{"name": "base", "type": "static"}, {"name": "arm", "shapes": [{"box": {"size": [2, 1]}}]}],
        "joints": [{"name": "hinge", "type": "revolute", "bodies": ["base", "arm"], "anchor": [0, 0],
                    "motor": {"speed": 0, "max_torque": 1e5}}],
        "custom": {"env": {
            "actions": [{"motor_speed": "hinge", "range": [-2, 2]}],
            "observations": [{"name": "angle", "body": "arm", "of": "angle"}, {"name": "speed", "joint": "hinge", "of": "speed"},
                             {"name": "angle_deg", "value": "arm.angle"}, {"name": "speed_deg", "value": "arm.spin"}],
            "random": [{"body": "arm", "of": "angle", "range": [0.5, 0.5]}]}}})  # fmt: skip
    env = tumble.env.TumbleEnv(scene)
    env.reset(seed=1)
    angle, speed, angle_deg, speed_deg = env.step([9])[0]  # beyond 1, which counts as 1
    assert speed == pytest.approx(2, rel=1e-3) and angle == pytest.approx(0.5 + 2 / 60, rel=1e-3)
    assert np.allclose([angle_deg, speed_deg], np.degrees([angle, speed]), rtol=1e-5)


def test_a_declaration_takes_numbers_of_numpy():
    def first(change):
        scene = tumble.env.scene_of("cart_pole")
        change(scene.data["custom"]["env"])
        env = tumble.env.TumbleEnv(scene)
        env.reset(seed=1)
        return env.step(1)[0].tolist()

    def ranges(of):
        def change(declared):
            declared["actions"][0]["range"], declared["steps"] = of([-5.0, 5.0]), 50
        return change

    assert first(ranges(np.array)) == first(ranges(list)) != first(lambda declared: None)
    assert first(lambda declared: declared.update(steps=np.int64(50))) == first(lambda declared: None)


def test_an_error_in_an_expression_points_into_its_text():
    scene = tumble.Scene.parse('{"format": 1,\n "custom": {"env": {"reward": "1 + wrong"}}}', "made.json")
    with pytest.raises(tumble.SceneError) as caught:
        tumble.env.TumbleEnv(scene)
    assert (caught.value.file, caught.value.line, caught.value.column) == ("made.json", 2, 36)


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


def test_rewards_and_ends_are_in_the_grammar_of_claims():
    """The same texts have the same values in a run of the scene and in its environment."""
    scene = tumble.env.scene_of("cart_pole")
    texts = ["cart.x", "pole.angle + 2 * pole.vy", "hinge.speed", "step", "time",
             "if(cart.x > 0.001, 1, -1)", "distance(cart, pole)", "exp(-abs(cart.vx))"]  # fmt: skip
    env = scene.data["custom"]["env"]
    env["observations"] = [{"name": f"seen_{i}", "value": text} for i, text in enumerate(texts)]
    env["random"], env["done"] = [], "step >= 30 and not touching(cart, rail)"
    env["reward"] = "seen_0 - previous_seen_0 + 10 * action_push"
    envs = tumble.env.VectorEnv(scene, 2)
    run = scene.start()
    before = envs.reset()[0][0, 0].copy()
    for step in range(1, 30):
        run.bodies["cart"].apply_force((10 if step % 3 else -10, 0), run.bodies["cart"].position)
        run.step()
        observations, rewards, terminated, *_ = envs.step([1 if step % 3 else 0] * 2)
        assert observations[1].tolist() == [np.float32(run.value(text)) for text in texts]
        assert rewards[1] == float(observations[1, 0]) - float(before) + 10 * (1 if step % 3 else -1)
        assert not terminated.any()
        before = observations[1, 0].copy()
    assert envs.step([0, 0])[2].all()


def test_an_unknown_value_is_nan_and_an_unknown_end_does_not_hold():
    scene = tumble.env.scene_of("cart_pole")
    scene.data["timeline"] = [{"at": 1, "spawn": {"name": "late", "shapes": [{"circle": {"radius": 0.1}}]}}]
    scene.data["custom"]["env"].update(reward="late.x", done="late.x < 1")
    envs = tumble.env.VectorEnv(scene, 1)
    envs.reset()
    _, rewards, terminated, *_ = envs.step([0])
    assert np.isnan(rewards[0]) and not terminated[0]


def test_velocities_spins_and_targets_are_actions():
    scene = tumble.Scene({
        "world": {"gravity": [0, 0], "steps_per_second": 100},
        "bodies": [{"name": "ground", "type": "static"},
                   {"name": "paddle", "type": "kinematic", "shapes": [{"box": {"size": [1, 0.1]}}]},
                   {"name": "ball", "position": [5, 5], "shapes": [{"circle": {"radius": 0.1}}]}],
        "joints": [{"name": "hand", "type": "mouse", "bodies": ["ground", "ball"], "anchor": [5, 5], "max_force": 100}],
        "custom": {"env": {
            "actions": [{"velocity": "paddle", "axis": [1, 0], "range": [-2, 2]},
                        {"velocity": "paddle", "axis": [0, 1], "range": [-2, 2]},
                        {"spin": "paddle", "range": [-1, 1]},
                        {"target": "hand", "axis": [1, 0], "point": [5, 5], "range": [-1, 1]}],
            "observations": [{"body": "paddle", "of": of} for of in ("x", "y", "angle")] + [{"body": "ball", "of": "x"}]}},
    })  # fmt: skip
    envs = tumble.env.VectorEnv(scene, 1)
    envs.reset()
    for _ in range(100):
        observations, *_ = envs.step([[0.5, -1, 1, 1]])
    assert observations[0] == pytest.approx([1, -2, 1, 6], abs=1e-2)


def test_random_starts_move_bodies_and_scale_their_properties():
    scene = tumble.Scene({
        "world": {"gravity": [0, 0]},
        "materials": {"wood": {"friction": 0.5}},
        "bodies": [{"name": "ball", "position": [1, 2], "shapes": [{"circle": {"radius": 0.5}, "material": "wood"}]}],
        "custom": {"env": {
            "observations": [{"body": "ball", "of": "x"}, {"body": "ball", "of": "y"}, {"body": "ball", "of": "angle"},
                             {"value": "ball.mass"}],
            "random": [{"body": "ball", "of": "x", "range": [1, 1]}, {"body": "ball", "of": "y", "range": [-3, -3]},
                       {"body": "ball", "of": "angle", "range": [0.5, 0.5]}, {"body": "ball", "of": "mass", "range": [2, 2]},
                       {"body": "ball", "of": "friction", "range": [0.5, 0.5]}]}},
    })  # fmt: skip
    envs = tumble.env.VectorEnv(scene, 3)
    assert envs.reset()[0][2] == pytest.approx([2, -1, 0.5, np.pi / 2], abs=1e-5)
    assert envs.world(2).bodies[0].shapes[0].friction == 0.25


def test_an_environment_has_at_most_a_thread_for_each_world():
    before = len(os.listdir("/proc/self/task"))
    envs = tumble.env.make_vector("cart_pole", 3, threads=50)
    assert len(os.listdir("/proc/self/task")) - before == 2  # the third is the caller's
    del envs


def test_a_reset_that_is_refused_changes_nothing():
    class Busy:
        def reset(self, *arguments):
            raise tumble.InUseError("another thread is stepping these worlds")

    envs = tumble.env.make_vector("cart_pole", 2, threads=1)
    envs.reset(seed=1)
    envs.step(np.zeros(2, int))
    envs._worlds = Busy()
    with pytest.raises(tumble.InUseError):
        envs.reset()
    assert envs.steps.tolist() == [1, 1]


def test_a_step_costs_little_more_than_that_of_its_worlds():
    """512 cart-poles: the ratio to as many bare steps is 1.3 on an idle machine."""
    envs = tumble.env.make_vector("cart_pole", 512, threads=1)
    envs.reset(seed=1)
    worlds = [envs.world(i) for i in range(512)]
    actions, whole, bare = np.zeros(512, int), [], []
    for _ in range(20):
        start = time.perf_counter()
        envs.step(actions)
        whole.append(time.perf_counter() - start)
        start = time.perf_counter()
        for world in worlds:
            world.step()
        bare.append(time.perf_counter() - start)
    assert min(whole) < 2 * min(bare)
