"""One object of a declared environment: its members with their types, and errors with file, line and column."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING, Any, NoReturn

from tumble import _tumble

if TYPE_CHECKING:
    from tumble.scene import Scene

_REQUIRED: Any = object()


class Entry:
    """A value in custom.env of a scene, which must be an object."""

    def __init__(self, scene: Scene, value: Any, place: str, what: str) -> None:
        self._scene, self._what = scene, what
        self.place = place  #: the JSON pointer of the value in custom.env
        self._members: Mapping[str, Any] = value if isinstance(value, dict) else {}
        if not isinstance(value, dict):
            self.refuse(f"{what} must be an object, got {value!r}")

    def __contains__(self, name: str) -> bool:
        return name in self._members

    def refuse(self, message: str, name: str | None = None, hint: str = "", *, at_key: bool = False) -> NoReturn:
        """Raises SceneError at a member, or at the object."""
        text, file = self._scene._places()
        member = "" if name is None else "/" + name.replace("~", "~0").replace("/", "~1")
        _tumble.refuse_value(text, file, "/custom/env" + self.place + member, message, hint, at_key)
        raise AssertionError("refuse_value has returned")

    def allow(self, names: Collection[str]) -> None:
        """Refuses members with other names."""
        for name in self._members:
            if name not in names:
                self.refuse(f"{self._what} has no '{name}'", name, _tumble.suggestion(name, sorted(names)), at_key=True)

    def get(self, name: str, default: Any = _REQUIRED) -> Any:
        """A member of any type."""
        if name not in self._members and default is _REQUIRED:
            self.refuse(f"{self._what} needs '{name}'")
        return self._members.get(name, default)

    def text(self, name: str, default: Any = _REQUIRED) -> str:
        """A string."""
        return str(self._checked(name, default, lambda value: isinstance(value, str), "a text"))

    def number(self, name: str, default: Any = _REQUIRED) -> float:
        """A finite number."""
        return float(self._checked(name, default, _is_number, "a number"))

    def pair(self, name: str, default: Any = _REQUIRED) -> tuple[float, float]:
        """Two finite numbers."""
        x, y = self._checked(name, default, _is_pair, "two numbers")
        return float(x), float(y)

    def whole(self, name: str, default: Any, least: int, most: int) -> int:
        """A whole number from `least` to `most`."""
        def is_valid(value: Any) -> bool:
            return _is_number(value) and value == int(value) and least <= value <= most

        return int(self._checked(name, default, is_valid, f"a whole number from {least} to {most}"))

    def truth(self, name: str, default: bool) -> bool:
        """true or false."""
        return bool(self._checked(name, default, lambda value: isinstance(value, bool), "true or false"))

    def name_in(self, table: Mapping[str, int], name: str, what: str, *, value: Any = None) -> int:
        """The id of the body or joint that a member names."""
        named = self.get(name) if value is None else value
        if not isinstance(named, str) or named not in table:
            hint = _tumble.suggestion(named, sorted(table)) if isinstance(named, str) else ""
            self.refuse(f"there is no {what} {named!r}", name, hint)
        return table[named]

    def entries(self, name: str, what: str) -> Iterator[Entry]:
        """The objects of a list, which may be left out."""
        for i, value in enumerate(self._checked(name, [], lambda value: isinstance(value, list), "a list")):
            yield Entry(self._scene, value, f"{self.place}/{name}/{i}", what)

    def _checked(self, name: str, default: Any, is_valid: Any, what: str) -> Any:
        value = self.get(name, default)
        if name in self._members and not is_valid(value):
            self.refuse(f"{name} must be {what}, got {value!r}", name)
        return value


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _is_pair(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and len(value) == 2 and all(map(_is_number, value))
