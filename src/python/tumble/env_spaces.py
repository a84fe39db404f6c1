"""The base class and the spaces of environments: those of gymnasium, if it is installed."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["EnvBase", "spaces"]

try:  # gymnasium's classes, if it is installed
    import gymnasium  # type: ignore[import]
    from gymnasium import spaces

    EnvBase: Any = gymnasium.Env
except ImportError:
    gymnasium = None
    EnvBase = object

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
