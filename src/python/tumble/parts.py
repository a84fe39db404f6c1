"""What bodies, shapes and joints have in common."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from tumble import _tumble

if TYPE_CHECKING:
    from tumble.world import World


def index_of(names: Sequence[str], name: str, what: str) -> int:
    if not isinstance(name, str) or name not in names:
        raise ValueError(f"{what} must be one of {', '.join(names)}, got {name!r}")
    return names.index(name)


def counted(count: int, noun: str) -> str:
    """"1 shape", "2 bodies"."""
    if count == 1:
        return f"1 {noun}"
    return f"{count} {noun[:-1]}ies" if noun.endswith("y") else f"{count} {noun}s"


def id_in(box: _tumble.World, part: object, kind: type[Part], name: str) -> int:
    """The id of a part of a world, or the right exception."""
    if not isinstance(part, kind):
        raise TypeError(f"{name} must be a {kind.__name__}, got {part!r}")
    if part._box is not box:
        raise ValueError(f"{name} must be in this world")
    return part._id


class Part:
    """Something in a world, by its id. Equal if world and id are equal."""

    __slots__ = ("_box", "_id", "_world")

    def __init__(self, world: World, id: int) -> None:
        self._world = world
        self._box = world._box
        self._id = id

    @property
    def world(self) -> World:
        """The world that it is in."""
        return self._world

    @property
    def id(self) -> int:
        """The number that contacts and events name it by."""
        return self._id

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._id == other._id and self._box is other._box  # type: ignore[attr-defined]

    def __hash__(self) -> int:
        return hash((type(self).__name__, self._id))
