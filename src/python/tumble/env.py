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
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from tumble import _tumble
from tumble.env_expressions import Expression
from tumble.env_spaces import EnvBase, spaces
from tumble.scene import Run, Scene
from tumble.world import World

_ACTIONS = ("force", "thrust", "torque", "motor_speed", "motor_effort")
_OF_BODY = ("x", "y", "angle", "velocity_x", "velocity_y", "angular_velocity")
_OF_JOINT = {"position": 6, "speed": 7}
_TOUCHING, _RAY = 8, 9
_RANDOM = ("velocity_x", "velocity_y", "angular_velocity", "gravity_scale", "impulse_x", "impulse_y")

Rows = npt.NDArray[np.float32]


class Plan:
    """The environment that a scene declares, with its names resolved to ids."""

    MEMBERS = frozenset({"actions", "choices", "observations", "reward", "done", "steps", "random", "frame_skip"})

    def __init__(self, scene: Scene) -> None:
        custom = scene.data.get("custom")
        declared = custom.get("env") if isinstance(custom, dict) else None
        if not isinstance(declared, dict):
            raise ValueError(f"{scene!r} declares no environment: it needs custom.env")
        unknown = set(declared) - self.MEMBERS
        if unknown:
            raise ValueError(f"custom.env has no '{sorted(unknown)[0]}'; it may have {', '.join(sorted(self.MEMBERS))}")
        run = Run(scene)
        self.start = run.world
        self._bodies = {name: body.id for name, body in run.bodies.items()}
        self._joints = {name: joint.id for name, joint in run.joints.items()}
        self.actions = [self._action(entry) for entry in declared.get("actions", [])]
        self.choices: Rows | None = None
        if "choices" in declared:
            self.choices = np.asarray(declared["choices"], dtype=np.float32)
            if self.choices.ndim != 2 or self.choices.shape[1] != len(self.actions):
                raise ValueError(f"custom.env.choices must have the shape (n, {len(self.actions)})")
        self.names: list[str] = []
        self.observations: list[dict[str, Any]] = []
        for entry in declared.get("observations", []):
            self._observe(entry)
        self.randoms = [self._random(entry) for entry in declared.get("random", [])]
        self.steps = int(declared.get("steps", 0))
        self.frame_skip = int(declared.get("frame_skip", 1))
        known = {*self.names, *(f"previous_{name}" for name in self.names), "step",
                 *(f"action_{name}" for name in self.action_names(declared))}  # fmt: skip
        self.actions_named = self.action_names(declared)
        self.reward = Expression(str(declared.get("reward", "0")), known, "custom.env.reward")
        self.done = Expression(str(declared.get("done", "0 > 1")), known, "custom.env.done")

    @staticmethod
    def action_names(declared: Mapping[str, Any]) -> list[str]:
        return [str(entry.get("name", i)) for i, entry in enumerate(declared.get("actions", []))]

    def _find(self, table: Mapping[str, int], name: Any, what: str) -> int:
        if name not in table:
            raise ValueError(f"custom.env: there is no {what} '{name}'; known are {', '.join(sorted(table)) or 'none'}")
        return table[name]

    def _body(self, name: Any) -> int:
        return self._find(self._bodies, name, "body")

    def _joint(self, name: Any) -> int:
        return self._find(self._joints, name, "joint")

    def _action(self, entry: Mapping[str, Any]) -> dict[str, Any]:
        kinds = [kind for kind in _ACTIONS if kind in entry]
        if len(kinds) != 1:
            raise ValueError(f"custom.env: an action needs one of {', '.join(_ACTIONS)}, got {dict(entry)}")
        kind = kinds[0]
        low, high = entry.get("range", [-1, 1])
        plan: dict[str, Any] = {"kind": _ACTIONS.index(kind), "low": float(low), "high": float(high)}
        if kind.startswith("motor"):
            plan["joint"] = self._joint(entry[kind])
            plan["speed"] = float(entry.get("speed", 0.0))
        else:
            plan["body"] = self._body(entry[kind])
            plan["axis"] = tuple(map(float, entry.get("axis", (1, 0))))
            plan["point"] = tuple(map(float, entry.get("point", (0, 0))))
        return plan

    def _observe(self, entry: Mapping[str, Any]) -> None:
        scaled = {"scale": float(entry.get("scale", 1.0)), "offset": float(entry.get("offset", 0.0))}
        name = str(entry.get("name", f"observation_{len(self.names)}"))
        if "rays" in entry:
            ways = self._ways(entry)
            body = self._body(entry["rays"])
            for i, way in enumerate(ways):
                self.names.append(f"{name}_{i}")
                self.observations.append({"kind": _RAY, "body": body, "axis": way, **scaled,
                                          "point": tuple(map(float, entry.get("point", (0, 0)))),
                                          "turns": bool(entry.get("turns", False))})  # fmt: skip
            return
        self.names.append(name)
        if "touches" in entry:
            one, *other = entry["touches"] if isinstance(entry["touches"], list) else [entry["touches"]]
            plan: dict[str, Any] = {"kind": _TOUCHING, "body": self._body(one), **scaled}
            if other:
                plan["other"] = self._body(other[0])
        elif "joint" in entry and entry.get("of") in _OF_JOINT:
            plan = {"kind": _OF_JOINT[entry["of"]], "joint": self._joint(entry["joint"]), **scaled}
        elif "body" in entry and entry.get("of") in _OF_BODY:
            plan = {"kind": _OF_BODY.index(entry["of"]), "body": self._body(entry["body"]), **scaled}
        else:
            raise ValueError(f"custom.env: an observation needs body and of ({', '.join(_OF_BODY)}), joint and of "
                             f"({', '.join(_OF_JOINT)}), touches or rays, got {dict(entry)}")  # fmt: skip
        self.observations.append(plan)

    @staticmethod
    def _ways(entry: Mapping[str, Any]) -> list[tuple[float, float]]:
        first, last = np.radians(entry.get("angles", (0, 360)))
        count = int(entry.get("count", 1))
        length = float(entry.get("length", 10.0))
        angles = np.linspace(first, last, count)
        return [(length * float(np.cos(a)), length * float(np.sin(a))) for a in angles]

    def _random(self, entry: Mapping[str, Any]) -> dict[str, Any]:
        if entry.get("of") not in _RANDOM:
            raise ValueError(f"custom.env: random needs of ({', '.join(_RANDOM)}), got {dict(entry)}")
        low, high = entry["range"]
        return {"kind": _RANDOM.index(entry["of"]), "body": self._body(entry["body"]), "low": float(low),
                "high": float(high)}  # fmt: skip


class VectorEnv:
    """N copies of an environment, stepped by one call on all cores.

    `step` returns the observations [n, k] of the states after the step; worlds whose episode ended are reset in the same
    call, and their row has the first observation of the next episode. `final_observations` has the rows before the
    reset. The arrays are the environment's own and change with the next call.
    """

    def __init__(
        self, scene: Scene | str | os.PathLike[str], count: int, *, seed: int = 0, threads: int | None = None
    ) -> None:
        self.scene = scene if isinstance(scene, Scene) else Scene.load(scene)
        self.plan = Plan(self.scene)
        self.count = count
        if count < 1:
            raise ValueError(f"count must be at least 1, got {count}")
        threads = threads if threads is not None else min(count, len(os.sched_getaffinity(0)))
        if threads < 1:
            raise ValueError(f"threads must be at least 1, got {threads}")
        plan = self.plan
        self._worlds = _tumble.EnvWorlds(
            plan.start._box, plan.actions, plan.observations, plan.randoms, plan.frame_skip, count, threads, seed
        )
        shape = (count, len(plan.observations))
        self.observations: Rows = np.zeros(shape, np.float32)
        self.final_observations: Rows = np.zeros(shape, np.float32)
        self._previous: Rows = np.zeros(shape, np.float32)
        self._failed = np.zeros(count, np.uint8)
        self.steps = np.zeros(count, np.int64)  #: of the present episodes

    def __repr__(self) -> str:
        return f"<VectorEnv of {self.count} x {self.scene!r}>"

    def reset(self, *, seed: int | None = None) -> Rows:
        """Starts a new episode in all worlds; a seed starts from episode 0 again. Returns the observations."""
        if seed is not None:
            self._worlds.seed(seed)
        self.steps[:] = 0
        self._worlds.reset(np.ones(self.count, np.uint8), self.observations)
        return self.observations

    def step(self, actions: Any) -> tuple[Rows, npt.NDArray[np.float64], npt.NDArray[np.bool_], npt.NDArray[np.bool_]]:
        """Acts ([n, k] in [-1, 1], or [n] indices of choices) and steps.

        Returns observations [n, k], rewards [n], terminated [n], truncated [n].
        """
        rows = self._rows(actions)
        plan = self.plan
        np.copyto(self._previous, self.observations)
        self._worlds.step(rows, self.observations, self._failed)
        self.steps += 1
        values = _values(plan, self.observations, self._previous, rows, self.steps)
        rewards = np.broadcast_to(np.asarray(plan.reward(values), np.float64), (self.count,)).copy()
        failed = self._failed != 0
        terminated = np.broadcast_to(plan.done(values), (self.count,)) | failed
        rewards[failed] = 0.0
        truncated = (self.steps >= plan.steps) & ~terminated if plan.steps > 0 else np.zeros(self.count, np.bool_)
        ended = terminated | truncated
        if ended.any():
            np.copyto(self.final_observations, self.observations)
            self._worlds.reset(ended.astype(np.uint8), self.observations)
            self.steps[ended] = 0
        return self.observations, rewards, terminated, truncated

    def _rows(self, actions: Any) -> Rows:
        if self.plan.choices is not None:
            indices = np.asarray(actions)
            if indices.shape != (self.count,) or indices.dtype.kind not in "iu":
                raise ValueError(f"actions must be {self.count} indices of choices, got {indices.dtype} {indices.shape}")
            if ((indices < 0) | (indices >= len(self.plan.choices))).any():
                raise ValueError(f"actions must be indices below {len(self.plan.choices)}")
            chosen: Rows = self.plan.choices[indices]
            return chosen
        rows: Rows = np.ascontiguousarray(actions, dtype=np.float32)
        if rows.shape != (self.count, len(self.plan.actions)):
            raise ValueError(f"actions must have the shape {(self.count, len(self.plan.actions))}, got {rows.shape}")
        if not np.isfinite(rows).all():
            raise ValueError("actions must be finite")
        return rows

    def state_hash(self, index: int = 0) -> str:
        """Of one of the worlds."""
        return f"{self._worlds.state_hash(index):016x}"

    def world(self, index: int = 0) -> World:
        """A copy of one of the worlds."""
        if not 0 <= index < self.count:
            raise IndexError(f"there are {self.count} worlds, got {index}")
        return World.load(self._worlds.save(index))


def _values(plan: Plan, now: Rows, before: Rows, actions: Rows, steps: npt.NDArray[np.int64]) -> dict[str, Any]:
    """The arrays that reward and done name."""
    wanted = plan.reward.names | plan.done.names
    values: dict[str, Any] = {"step": steps} if "step" in wanted else {}
    for i, name in enumerate(plan.names):
        if name in wanted:
            values[name] = now[:, i].astype(np.float64)
        if f"previous_{name}" in wanted:
            values[f"previous_{name}"] = before[:, i].astype(np.float64)
    for i, name in enumerate(plan.actions_named):
        if f"action_{name}" in wanted:
            values[f"action_{name}"] = np.clip(actions[:, i], -1, 1).astype(np.float64)
    return values


class TumbleEnv(EnvBase):  # type: ignore[misc]
    """One environment of a scene, with gymnasium's `reset` and `step`.

    >>> env = TumbleEnv("cart_pole.json")
    >>> observation, info = env.reset(seed=1)
    >>> observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 60}

    def __init__(self, scene: Scene | str | os.PathLike[str], *, render_mode: str | None = None) -> None:
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode must be None or 'rgb_array', got {render_mode!r}")
        self.render_mode = render_mode
        self._envs = VectorEnv(scene, 1, threads=1)
        self.scene, self.plan = self._envs.scene, self._envs.plan
        self.observation_space = spaces.Box(-np.inf, np.inf, (len(self.plan.observations),), np.float32)
        self.action_space: Any
        if self.plan.choices is not None:
            self.action_space = spaces.Discrete(len(self.plan.choices))
        else:
            self.action_space = spaces.Box(-1.0, 1.0, (len(self.plan.actions),), np.float32)
        self._ended = True
        self._camera: tuple[tuple[float, float], float] | None = None

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[npt.NDArray[np.float32], dict[str, Any]]:
        """Starts an episode. The same seed gives the same episode, bit for bit."""
        self._ended = False
        return self._envs.reset(seed=seed)[0].copy(), {}

    def step(self, action: Any) -> tuple[npt.NDArray[np.float32], float, bool, bool, dict[str, Any]]:
        """Returns observation, reward, terminated, truncated, info."""
        if self._ended:
            raise RuntimeError("the episode has ended: call reset()")
        actions = np.asarray([action])
        rows = self._envs._rows(actions)
        observations, rewards, terminated, truncated = self._envs.step(actions if self.plan.choices is not None else rows)
        self._ended = bool(terminated[0] or truncated[0])
        shown = self._envs.final_observations if self._ended else observations
        return shown[0].copy(), float(rewards[0]), bool(terminated[0]), bool(truncated[0]), {}

    def render(self) -> npt.NDArray[np.uint8]:
        """A frame [height, width, 3]."""
        world = self._envs.world()
        if self._camera is None:
            from tumble.rendering import fitted_camera

            self._camera = fitted_camera(self.plan.start)
        pixels: npt.NDArray[np.uint8] = world.render(600, 400, center=self._camera[0], view_height=self._camera[1])[..., :3]
        return pixels

    def close(self) -> None:
        pass


def make(name: str, **options: Any) -> TumbleEnv:
    """One of the environments that come with tumble: see `names`."""
    return TumbleEnv(scene_of(name), **options)


def make_vector(name: str, count: int, *, seed: int = 0, threads: int | None = None) -> VectorEnv:
    """Many copies of one of the environments that come with tumble."""
    return VectorEnv(scene_of(name), count, seed=seed, threads=threads)


def names() -> list[str]:
    """The environments that come with tumble."""
    from pathlib import Path

    return sorted(file.stem for file in (Path(__file__).parent / "envs").glob("*.json"))


def scene_of(name: str) -> Scene:
    """The scene of one of them, to be changed and given to TumbleEnv."""
    from pathlib import Path

    known: Sequence[str] = names()
    if name not in known:
        raise ValueError(f"there is no environment '{name}'; known are {', '.join(known)}")
    return Scene.load(Path(__file__).parent / "envs" / f"{name}.json")
