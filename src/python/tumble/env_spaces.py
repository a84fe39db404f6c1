"""The base classes and the spaces of environments: those of gymnasium, if it is installed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from tumble.env_plan import Plan

__all__ = ["EnvBase", "VectorEnvBase", "action_space", "autoreset_mode", "gymnasium", "observation_space", "spaces"]

try:  # gymnasium's classes, if it is installed
    import gymnasium  # type: ignore[import]
    from gymnasium import spaces

    EnvBase: Any = gymnasium.Env
    VectorEnvBase: Any = gymnasium.vector.VectorEnv
except ImportError:
    gymnasium = None

    class _Base:
        """What the environments need of gymnasium's classes."""

        def reset(self, *, seed: int | None = None, options: Any = None) -> None:
            """gymnasium seeds its generator here."""

        def close(self) -> None:
            """There is nothing to be freed."""

    EnvBase = VectorEnvBase = _Base

    class _Spaces:
        """Stand-ins with the members that agents read."""

        class Box:
            def __init__(self, low: float, high: float, shape: tuple[int, ...], dtype: Any = np.float32) -> None:
                self.low, self.high = np.full(shape, low, dtype), np.full(shape, high, dtype)
                self.shape, self.dtype = shape, dtype
                self._random = np.random.default_rng()

            def seed(self, seed: int | None = None) -> None:
                self._random = np.random.default_rng(seed)

            def sample(self) -> npt.NDArray[Any]:
                if not np.isfinite(self.low).all() or not np.isfinite(self.high).all():  # as gymnasium does
                    return self._random.normal(size=self.shape).astype(self.dtype)
                return self._random.uniform(self.low, self.high).astype(self.dtype)

            def contains(self, value: Any) -> bool:
                value = np.asarray(value)
                return bool(value.shape == self.shape and (value >= self.low).all() and (value <= self.high).all())

            def __repr__(self) -> str:
                return f"Box(shape={self.shape})"

        class Discrete:
            def __init__(self, n: int) -> None:
                self.n = n
                self.shape: tuple[int, ...] = ()
                self.dtype = np.int64
                self._random = np.random.default_rng()

            def seed(self, seed: int | None = None) -> None:
                self._random = np.random.default_rng(seed)

            def sample(self) -> int:
                return int(self._random.integers(self.n))

            def contains(self, value: Any) -> bool:
                return 0 <= int(value) < self.n

            def __repr__(self) -> str:
                return f"Discrete({self.n})"

        class MultiDiscrete:
            def __init__(self, nvec: list[int]) -> None:
                self.nvec = np.array(nvec, np.int64)
                self.shape, self.dtype = self.nvec.shape, np.int64
                self._random = np.random.default_rng()

            def seed(self, seed: int | None = None) -> None:
                self._random = np.random.default_rng(seed)

            def sample(self) -> npt.NDArray[np.int64]:
                return self._random.integers(self.nvec)

            def contains(self, value: Any) -> bool:
                value = np.asarray(value)
                return bool(value.shape == self.shape and (value >= 0).all() and (value < self.nvec).all())

            def __repr__(self) -> str:
                return f"MultiDiscrete(shape={self.shape})"

        class Dict:
            def __init__(self, spaces: dict[str, Any]) -> None:
                self.spaces = spaces

            def __getitem__(self, name: str) -> Any:
                return self.spaces[name]

            def seed(self, seed: int | None = None) -> None:
                for space in self.spaces.values():
                    space.seed(seed)

            def sample(self) -> dict[str, Any]:
                return {name: space.sample() for name, space in self.spaces.items()}

            def contains(self, value: Any) -> bool:
                return value.keys() == self.spaces.keys() and all(
                    space.contains(value[name]) for name, space in self.spaces.items()
                )

            def __repr__(self) -> str:
                return f"Dict({self.spaces})"

    spaces = _Spaces()


def autoreset_mode() -> Any:
    """How a VectorEnv starts new episodes: in the step that ends the old one."""
    modes = getattr(getattr(gymnasium, "vector", None), "AutoresetMode", None)
    return "SameStep" if modes is None else modes.SAME_STEP


def observation_space(plan: Plan, count: int | None = None) -> Any:
    """Of one environment, or of `count` in one array."""
    many = () if count is None else (count,)
    state = spaces.Box(-np.inf, np.inf, (*many, len(plan.observations)), np.float32)
    if not plan.images:
        return state
    parts = {"state": state} if plan.observations else {}
    for name in plan.images:
        size, kind = plan.image_shape(name)
        parts[name] = spaces.Box(0, np.iinfo(kind).max, (*many, *size), kind)
    return spaces.Dict(parts)


def action_space(plan: Plan, count: int | None = None) -> Any:
    """Of one environment, or of `count` in one array."""
    if plan.choices is not None:
        return spaces.Discrete(len(plan.choices)) if count is None else spaces.MultiDiscrete([len(plan.choices)] * count)
    many = () if count is None else (count,)
    return spaces.Box(-1.0, 1.0, (*many, len(plan.actions)), np.float32)
