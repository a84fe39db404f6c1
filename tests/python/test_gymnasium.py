"""With gymnasium, by a stand-in for it, as Debian does not have it: its classes are used, and environments registered."""

import importlib
import sys
import types

import numpy as np
import pytest


class Space:
    """A space that keeps what it was made of."""

    def __init__(self, *arguments):
        self.arguments = arguments


class Env:
    """gymnasium.Env seeds its generator in reset."""

    def reset(self, *, seed=None, options=None):
        self.seeds = [*getattr(self, "seeds", []), seed]

    def close(self):
        self.is_closed = True


class VectorEnv(Env):
    pass


def stand_in():
    gymnasium = types.ModuleType("gymnasium")
    gymnasium.Env = Env
    gymnasium.spaces = types.ModuleType("gymnasium.spaces")
    for name in ("Box", "Discrete", "MultiDiscrete", "Dict"):
        setattr(gymnasium.spaces, name, type(name, (Space,), {}))
    gymnasium.vector = types.SimpleNamespace(VectorEnv=VectorEnv, AutoresetMode=types.SimpleNamespace(SAME_STEP="same step"))
    gymnasium.registry = {}
    gymnasium.register = lambda id, **options: gymnasium.registry.update({id: options})
    return gymnasium


@pytest.fixture
def loaded(monkeypatch):
    """tumble.env and gymnasium, loaded in this order again."""
    import tumble

    gymnasium = stand_in()
    monkeypatch.setitem(sys.modules, "gymnasium", gymnasium)
    monkeypatch.setitem(sys.modules, "gymnasium.spaces", gymnasium.spaces)
    for name in ("tumble.env_spaces", "tumble.env"):
        monkeypatch.delitem(sys.modules, name, raising=False)
        monkeypatch.delattr(tumble, name.removeprefix("tumble."), raising=False)
    return importlib.import_module("tumble.env"), gymnasium


def test_environments_are_those_of_gymnasium(loaded):
    env_module, _ = loaded
    env = env_module.make("cart_pole", render_mode="rgb_array")
    assert isinstance(env, Env) and env.render_mode == "rgb_array"
    observation, info = env.reset(seed=5, options={})
    assert env.seeds == [5] and info == {} and observation.shape == (4,)
    assert env.metadata == {"render_modes": ["rgb_array"], "render_fps": pytest.approx(50)}
    assert env.action_space.arguments == (2,) and type(env.action_space).__name__ == "Discrete"
    assert env.observation_space.arguments[2] == (4,)
    assert len(env.step(1)) == 5
    env.close()
    assert env.is_closed


def test_vector_environments_report_the_ends_of_episodes(loaded):
    env_module, _ = loaded
    envs = env_module.make_vector("cart_pole", 3, threads=1)
    assert isinstance(envs, VectorEnv) and envs.num_envs == 3 and envs.metadata["autoreset_mode"] == "same step"
    assert envs.single_observation_space.arguments[2] == (4,) and envs.observation_space.arguments[2] == (3, 4)
    assert envs.single_action_space.arguments == (2,) and envs.action_space.arguments == ([2, 2, 2],)
    observations, infos = envs.reset(seed=1)
    assert observations.shape == (3, 4) and infos == {} and envs.seeds == [1]
    for _ in range(100):
        before = observations.copy()
        observations, rewards, terminated, truncated, infos = envs.step(np.array([1, 0, 1]))
        assert ("final_obs" in infos) == terminated.any()
        if terminated.any():
            break
    ended = infos["_final_obs"]
    assert ended.dtype == bool and np.array_equal(ended, terminated)
    assert np.abs(infos["final_obs"][ended] - before[ended]).max() < 1  # one step later
    assert np.abs(observations[ended, 2]).max() < 0.01  # the next episode


def test_environments_are_registered(loaded):
    env_module, gymnasium = loaded
    assert set(gymnasium.registry) == {f"tumble/{name}-v0" for name in env_module.names()}
    options = gymnasium.registry["tumble/pusher-v0"]
    assert options["entry_point"](render_mode=None).scene.data["name"] == "pusher"
    assert options["vector_entry_point"](num_envs=2).num_envs == 2
