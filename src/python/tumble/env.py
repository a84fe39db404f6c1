"""Learning environments from scenes, with the interface of gymnasium, which is used if it is installed.

A scene declares its environment in its custom data:

    "custom": {"env": {
        "actions": [{"name": "push", "force": "cart", "axis": [1, 0], "range": [-10, 10]}],
        "choices": [[-1], [1]],
        "observations": [{"name": "x", "body": "cart", "of": "x"}, {"name": "angle", "joint": "hinge", "of": "position"}],
        "reward": "1",
        "done": "abs(x) > 2.4 or abs(angle) > 0.2",
        "steps": 500,
        "random": [{"body": "pole", "of": "angular_velocity", "range": [-0.05, 0.05]}]}}

The page src/python/README.md lists all members. The timeline and the claims of the scene are not part of an environment.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from tumble import _tumble
from tumble.env_plan import Plan, Rows
from tumble.env_spaces import EnvBase, VectorEnvBase, action_space, autoreset_mode, gymnasium, observation_space
from tumble.scene import Scene
from tumble.shapes import array_of, threads_of, whole
from tumble.world import World

#: Rows [n, k], or a dictionary if the scene declares images: "state" with the rows, and an array for each image.
Observations = Any


def _seed_of(value: int) -> int:
    return whole(value, "seed", 0, 2**64 - 1)


class VectorEnv(VectorEnvBase):  # type: ignore[misc]
    """N copies of an environment, stepped by one call on all cores, with the interface of gymnasium's VectorEnv.

    `step` returns the observations [n, k] of the states after the step; worlds whose episode ended are reset in the same
    call, and their row has the first observation of the next episode. `infos["final_obs"]` has the rows before the reset,
    and `infos["_final_obs"]` [n] tells which worlds ended. The arrays are the environment's own and change with the next
    call.

    With images, observations are a dictionary: "state" has the rows, and each image an array of its name, pixels
    [n, height, width, 3] of uint8 or a mask [n, height, width] of uint16. `images` and `final_images` have them too.
    """

    def __init__(
        self, scene: Scene | str | os.PathLike[str], count: int, *, seed: int = 0, threads: int | None = None
    ) -> None:
        """`count` worlds from the scene or its file. `threads` is by default one for each processor."""
        self.scene = scene if isinstance(scene, Scene) else Scene.load(scene)
        self.plan = Plan(self.scene)
        self.count = self.num_envs = count = whole(count, "count", 1, 2**31 - 1)
        plan, crew = self.plan, min(count, threads_of(threads))
        self._worlds = _tumble.EnvWorlds(plan.start._box, plan.resolved(), count, crew, _seed_of(seed))
        shape = (count, len(plan.observations))
        self.observations: Rows = np.zeros(shape, np.float32)
        self.final_observations: Rows = np.zeros(shape, np.float32)
        kinds = {name: plan.image_shape(name) for name in plan.images}
        self.images: dict[str, npt.NDArray[Any]] = {
            name: np.zeros((count, *size), kind) for name, (size, kind) in kinds.items()
        }
        self.final_images = {name: np.zeros_like(image) for name, image in self.images.items()}
        self._no_rows, self._no_choices = np.zeros(0, np.float32), np.zeros(0, np.int64)
        self.steps = np.zeros(count, np.int64)  #: of the present episodes
        self.single_observation_space, self.single_action_space = observation_space(plan), action_space(plan)
        self.observation_space, self.action_space = observation_space(plan, count), action_space(plan, count)
        self.metadata = {"render_modes": [], "render_fps": plan.fps, "autoreset_mode": autoreset_mode()}
        self.render_mode = None

    def __repr__(self) -> str:
        return f"<VectorEnv of {self.count} x {self.scene!r}>"

    def _shown(self, rows: Rows, images: dict[str, npt.NDArray[Any]]) -> Observations:
        if not images:
            return rows
        return {"state": rows, **images} if rows.shape[1] else dict(images)

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[Observations, dict[str, Any]]:
        """Starts a new episode in all worlds; a seed starts from episode 0 again. Returns observations and infos."""
        seed = None if seed is None else _seed_of(seed)
        super().reset(seed=seed)
        if seed is not None:
            self._worlds.seed(seed)
        self._worlds.reset(self.observations, list(self.images.values()))
        self.steps[:] = 0
        return self._shown(self.observations, self.images), {}

    def step(
        self, actions: Any
    ) -> tuple[Observations, npt.NDArray[np.float64], npt.NDArray[np.bool_], npt.NDArray[np.bool_], dict[str, Any]]:
        """Acts ([n, k] in [-1, 1], or [n] indices of choices) and steps.

        Returns observations [n, k], rewards [n], terminated [n], truncated [n], infos.
        """
        chooses = self.plan.choices is not None
        rows = self._no_rows if chooses else self._rows(actions)
        choices = self._choices(actions) if chooses else self._no_choices
        rewards = np.empty(self.count)
        terminated, truncated = np.empty(self.count, np.bool_), np.empty(self.count, np.bool_)
        self._worlds.step(
            rows, choices, self.observations, self.final_observations, list(self.images.values()),
            list(self.final_images.values()), rewards, terminated.view(np.uint8), truncated.view(np.uint8), self.steps
        )  # fmt: skip
        infos: dict[str, Any] = {}
        ended = terminated | truncated
        if ended.any():
            infos = {"final_obs": self._shown(self.final_observations, self.final_images), "_final_obs": ended}
        return self._shown(self.observations, self.images), rewards, terminated, truncated, infos

    def _choices(self, actions: Any) -> npt.NDArray[np.int64]:
        indices = np.asarray(actions)
        if indices.shape != (self.count,) or indices.dtype.kind not in "iu":
            raise ValueError(f"actions must be {self.count} indices of choices, got {indices.dtype} {indices.shape}")
        return np.ascontiguousarray(indices, dtype=np.int64)

    def _rows(self, actions: Any) -> Rows:
        rows: Rows = array_of(actions, "actions", np.float32)
        if rows.shape != (self.count, len(self.plan.actions)):
            raise ValueError(f"actions must have the shape {(self.count, len(self.plan.actions))}, got {rows.shape}")
        if not np.isfinite(rows).all():
            raise ValueError("actions must be finite")
        return rows

    def _known(self, index: int) -> int:
        if not 0 <= index < self.count:
            raise IndexError(f"there are {self.count} worlds, got {index}")
        return index

    def state_hash(self, index: int = 0) -> str:
        """Of one of the worlds: 16 hexadecimal digits."""
        return f"{self._worlds.state_hash(self._known(index)):016x}"

    def world(self, index: int = 0) -> World:
        """A copy of one of the worlds."""
        return World.load(self._worlds.save(self._known(index)))


class TumbleEnv(EnvBase):  # type: ignore[misc]
    """One environment of a scene, with gymnasium's `reset` and `step`.

    >>> env = TumbleEnv("cart_pole.json")
    >>> observation, info = env.reset(seed=1)
    >>> observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 60}

    def __init__(self, scene: Scene | str | os.PathLike[str], *, render_mode: str | None = None) -> None:
        """The environment that the scene, or its file, declares."""
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode must be None or 'rgb_array', got {render_mode!r}")
        self.render_mode = render_mode
        self._envs = VectorEnv(scene, 1, threads=1)
        self.scene, self.plan = self._envs.scene, self._envs.plan
        self.metadata = {"render_modes": ["rgb_array"], "render_fps": self.plan.fps}
        self.observation_space = self._envs.single_observation_space
        self.action_space = self._envs.single_action_space
        self._ended = True
        self._camera: tuple[tuple[float, float], float] | None = None

    def __repr__(self) -> str:
        return f"<TumbleEnv of {self.scene!r}>"

    @staticmethod
    def _own(observations: Observations) -> Observations:
        """A copy of the only world's."""
        if isinstance(observations, dict):
            return {name: rows[0].copy() for name, rows in observations.items()}
        return observations[0].copy()

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[Observations, dict[str, Any]]:
        """Starts an episode. The same seed gives the same episode, bit for bit. Returns observation and info."""
        seed = None if seed is None else _seed_of(seed)
        super().reset(seed=seed)
        observations, info = self._envs.reset(seed=seed)
        self._ended = False
        return self._own(observations), info

    def step(self, action: Any) -> tuple[Observations, float, bool, bool, dict[str, Any]]:
        """Returns observation, reward, terminated, truncated, info."""
        if self._ended:
            raise RuntimeError("no episode is going on: call reset()")
        observations, rewards, terminated, truncated, infos = self._envs.step(np.asarray([self._checked(action)]))
        self._ended = bool(terminated[0] or truncated[0])
        shown = infos["final_obs"] if self._ended else observations
        return self._own(shown), float(rewards[0]), bool(terminated[0]), bool(truncated[0]), {}

    def _checked(self, action: Any) -> Any:
        """An index of a choice, or a row of numbers, or the right exception."""
        choices, given = self.plan.choices, np.asarray(action)
        if choices is not None and (given.shape != () or given.dtype.kind not in "iu"):
            raise ValueError(f"action must be an index of {len(choices)} choices, got {action!r}")
        if choices is None and given.shape != (len(self.plan.actions),):
            raise ValueError(f"action must have the shape ({len(self.plan.actions)},), got {action!r}")
        return given

    def render(self) -> npt.NDArray[np.uint8]:
        """A frame [height, width, 3].

        After the end of an episode it shows the start of the next one, which reset() replaces.
        """
        world = self._envs.world()
        if self._camera is None:
            from tumble.rendering import fitted_camera

            self._camera = fitted_camera(self.plan.start)
        pixels: npt.NDArray[np.uint8] = world.render(600, 400, center=self._camera[0], view_height=self._camera[1])[..., :3]
        return pixels


def make(name: str, **options: Any) -> TumbleEnv:
    """One of the environments that come with tumble: see `names`."""
    return TumbleEnv(scene_of(name), **options)


def make_vector(name: str, count: int, *, seed: int = 0, threads: int | None = None) -> VectorEnv:
    """Many copies of one of the environments that come with tumble."""
    return VectorEnv(scene_of(name), count, seed=seed, threads=threads)


def names() -> list[str]:
    """The environments that come with tumble."""
    return sorted(file.stem for file in (Path(__file__).parent / "envs").glob("*.json"))


def scene_of(name: str) -> Scene:
    """The scene of one of them, to be changed and given to TumbleEnv."""
    known: Sequence[str] = names()
    if name not in known:
        raise ValueError(f"there is no environment '{name}'; known are {', '.join(known)}")
    return Scene.load(Path(__file__).parent / "envs" / f"{name}.json")


def register() -> None:
    """Registers them with gymnasium as "tumble/NAME-v0". Called when this module is imported, if gymnasium is there."""
    for name in names():
        gymnasium.register(
            id=f"tumble/{name}-v0", entry_point=partial(make, name),
            vector_entry_point=lambda num_envs, name=name, **options: make_vector(name, num_envs, **options),
        )  # fmt: skip


if gymnasium is not None:
    register()
