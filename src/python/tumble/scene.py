"""Scenes: the description of a world as plain data, with a timeline and claims, and the runs of scenes."""

from __future__ import annotations

import copy
import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from tumble import _tumble
from tumble.bodies import Body
from tumble.errors import Diagnostic, SnapshotError
from tumble.joints import Joint
from tumble.parts import counted
from tumble.shapes import Vector, steps_of, text_of, whole
from tumble.world import World


class Claim(NamedTuple):
    """The result of one claim of a scene."""

    passed: bool  #: whether it holds; False if it is not decided
    claim: str  #: "'crate' is inside [0, 0] to [2, 3] at 4 s"
    finding: str  #: "it is at [2.5, 0.5]"
    step: int  #: the step that decided it
    time: float  #: s, of that step
    is_decided: bool  #: False for `picture` and `max_time_ratio`, which only `tumble check` decides


class Source(NamedTuple):
    """What a scene was read from."""

    text: str
    file: str
    custom: Any  #: the custom data that it has


def plain_value(value: Any) -> Any:
    """A number or an array of numpy as JSON has it."""
    if isinstance(value, (np.generic, np.ndarray)):
        return value.tolist()
    raise TypeError(f"{value!r} is a {type(value).__name__}")


class Scene:
    """A scene as plain data: `scene.data` is the content of its file, to be read and edited. It may have numpy's numbers.

    >>> scene = Scene.load("scenes/pyramid.json")
    >>> scene.data["world"] = {"gravity": [0, -1.6]}
    >>> run = scene.run(duration=2)
    >>> run.state_hash
    """

    def __init__(self, data: Mapping[str, Any] | None = None, *, name: str = "scene") -> None:
        """Takes a copy of the data. SceneError names what is wrong in it when it runs, or by `validate`."""
        if data is not None and not isinstance(data, Mapping):
            raise TypeError(f"data must be a dictionary, got {data!r}; Scene.load reads a file and Scene.parse a text")
        self.data: dict[str, Any] = copy.deepcopy(dict(data)) if data is not None else {"format": 1}
        self.data.setdefault("format", 1)
        self._name = name
        self._source: Source | None = None

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, set: Sequence[str] = (), seed: int | None = None,
             allow_outside: bool = False) -> Scene:  # fmt: skip
        """Reads a scene file and the files that it includes.

        `set` has overrides as on the command line, "/world/duration=3". `allow_outside` accepts paths in files that lead
        out of the folder of their file. Raises SceneError with file, line and column, or
        FileError.
        """
        if isinstance(set, str):
            raise TypeError(f"set must be a list of overrides, got {set!r}")
        seed = None if seed is None else whole(seed, "seed", 0, 2**64 - 1)
        text = _tumble.load_scene(os.fspath(path), list(set), seed, allow_outside)
        scene = cls(json.loads(text), name=Path(path).name)
        if not any(override.startswith("/custom") for override in set):
            scene._read_from(Path(path).read_text(encoding="utf-8", errors="replace"), os.fspath(path))
        return scene

    @classmethod
    def parse(cls, text: str, name: str = "scene") -> Scene:
        """Reads the text of a scene file, which may have comments. Raises SceneError with line and column."""
        scene = cls(json.loads(_tumble.canonical_text(text_of(text, "text"), name)), name=name)
        scene._read_from(text, name)
        return scene

    def _read_from(self, text: str, file: str) -> None:
        self._source = Source(text, file, copy.deepcopy(self.data.get("custom")))

    def validate(self) -> list[Diagnostic]:
        """The warnings about the scene, such as of bodies that overlap. Raises SceneError if it is not valid."""
        return _tumble.validate_scene(self._text(), self._name)

    def to_json(self) -> str:
        """The canonical text of the scene."""
        return _tumble.canonical_text(self._text(), self._name)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the canonical text."""
        Path(path).write_text(self.to_json(), encoding="utf-8")

    @property
    def hash(self) -> str:
        """16 hexadecimal digits of what is simulated: equal for scenes that run alike."""
        return f"{_tumble.scene_hash(self._text()):016x}"

    @property
    def bodies(self) -> list[dict[str, Any]]:
        """The bodies of the data, to be edited."""
        bodies: list[dict[str, Any]] = self.data.setdefault("bodies", [])
        return bodies

    def start(self, *, threads: int = 1) -> Run:
        """A run at its first state, to be stepped. Its steps are made by `threads`; 0: one a processor."""
        run = Run(self)
        run.world.threads = threads
        return run

    def run(self, duration: float | None = None, *, seed: int | None = None, threads: int = 1) -> Run:
        """Runs the scene for `duration` s with the random numbers of `seed`, by default its own, and evaluates its
        claims."""
        given = {"duration": duration, "seed": seed}
        changes = {key: value for key, value in given.items() if value is not None}
        scene = self
        if changes:
            scene = self.copy()
            scene.data.setdefault("world", {}).update(changes)
        run = scene.start(threads=threads)
        run.finish()
        return run

    def copy(self) -> Scene:
        """A scene with a copy of the data."""
        scene = Scene(self.data, name=self._name)
        scene._source = self._source
        return scene

    def _places(self) -> tuple[str, str]:
        """A text that has the custom data, and the name of its file: for errors in it."""
        if self._source is not None and self._source.custom == self._plain().get("custom"):
            return self._source.text, self._source.file
        return self._text(), self._name

    def _text(self) -> str:
        try:
            return json.dumps(self.data, allow_nan=False, default=plain_value)
        except (TypeError, ValueError) as error:
            raise ValueError(f"the data of a scene must be JSON: {error}") from None

    def _plain(self) -> dict[str, Any]:
        """The data with lists and numbers of Python in place of arrays and numbers of numpy."""
        plain: dict[str, Any] = json.loads(self._text())
        return plain

    def __repr__(self) -> str:
        name = self.data.get("name") or self._name
        sizes = [counted(len(self.data.get(key, [])), noun) for key, noun in (("bodies", "body"), ("joints", "joint"))]
        return f"<Scene {name!r}: {sizes[0]}, {sizes[1]}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self._plain() == other._plain()

    __hash__ = None  # type: ignore[assignment]

    def _repr_png_(self) -> bytes:
        return self.start()._repr_png_()


class Run:
    """A scene that runs: its world, its timeline and its claims.

    You may act on `world` between steps; the timeline continues.
    """

    def __init__(self, scene: Scene, *, _box: _tumble.World | None = None) -> None:
        text = scene._text()
        self._steps = _tumble.count_steps(text)
        self._box = _box if _box is not None else _tumble.start(text, scene._name)
        self.scene = scene.copy()
        self.world = World._of(self._box, True)

    def __repr__(self) -> str:
        return f"<Run of {self.scene!r} at {self.time:.3f} s, hash {self.state_hash}>"

    def step(self, count: int = 1) -> None:
        """Makes steps with the timeline, and observes the claims. A run that has stopped keeps its state."""
        self._box.step(steps_of(count))

    def finish(self) -> None:
        """Steps to the end of the scene's duration."""
        self._box.step(max(0, self._steps - self._box.step_count()))

    @property
    def is_stopped(self) -> bool:
        """Whether an event of the timeline has ended the run."""
        return _tumble.is_stopped(self._box)

    def value(self, expression: str) -> float | bool | None:
        """The value of an expression in the present state, as in claims: "ball.x > 3 and not touching(ball, floor)".

        Lengths are m and angles degrees, as in scene files. NaN or None if it is unknown. Raises ValueError.
        """
        return _tumble.run_value(self._box, text_of(expression, "expression"))

    @property
    def time(self) -> float:
        """s."""
        return self._box.time()

    @property
    def state_hash(self) -> str:
        """16 hexadecimal digits, as `tumble run` prints them."""
        return self.world.state_hash

    @property
    def bodies(self) -> dict[str, Body]:
        """The bodies by name; those without a name are body[i]. Spawned ones appear, destroyed ones disappear."""
        return {name: Body(self.world, id) for name, id in _tumble.run_bodies(self._box).items()}

    @property
    def joints(self) -> dict[str, Joint]:
        """The joints by name; those without a name are joint[i]."""
        return {name: Joint(self.world, id) for name, id in _tumble.run_joints(self._box).items()}

    @property
    def claims(self) -> list[Claim]:
        """The results of the claims so far, in the order of the scene: of a claim on the end, at the present state."""
        return [Claim(*result) for result in _tumble.run_claims(self._box)]

    @property
    def passed(self) -> bool:
        """Whether all claims are decided and hold. Those with `is_decided` False need `tumble check`."""
        return all(claim.passed for claim in self.claims)

    def save(self) -> tuple[str, bytes, bytes]:
        """The run with its timeline and claims, for `Run.load` and for pickle."""
        return _tumble.save_run(self._box)

    @staticmethod
    def load(saved: tuple[str, bytes, bytes]) -> Run:
        """Continues a saved run. Raises SnapshotError, or SceneError if its scene is not valid."""
        if not isinstance(saved, (tuple, list)) or [type(part) for part in saved] != [str, bytes, bytes]:
            raise SnapshotError("saved must be what Run.save returns: the text of a scene and two snapshots, as bytes")
        box = _tumble.load_run(*saved)
        return Run(Scene(json.loads(saved[0])), _box=box)

    def copy(self) -> Run:
        """A run in the same state, with its timeline and claims."""
        return Run.load(self.save())

    def __reduce__(self) -> tuple[Any, ...]:
        return Run.load, (self.save(),)

    def render(self, width: int = 640, height: int = 360, *, center: Vector | None = None,
               view_height: float | None = None, overlay: Sequence[str] = (),
               theme: str | None = None) -> npt.NDArray[np.uint8]:  # fmt: skip
        """A frame as an array [height, width, 4]: see `tumble.render`."""
        return self.world.render(width, height, center=center, view_height=view_height, overlay=overlay, theme=theme)

    def _repr_png_(self) -> bytes:
        return self.world._repr_png_()
