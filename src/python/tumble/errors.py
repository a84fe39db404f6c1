"""The exceptions of tumble.

A wrong argument (a dead body, a number that is not finite, a wrong shape of an array) is a ValueError or a TypeError, and
nothing changes. The classes below are for what comes from outside or from the simulation itself.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Diagnostic:
    """An error or a warning about a scene, with its place."""

    severity: str  #: "error" or "warning"
    file: str
    line: int  #: from 1; 0 if unknown
    column: int  #: from 1; 0 if unknown
    pointer: str  #: the JSON pointer of the value, "/bodies/0/shapes"
    message: str
    hint: str
    code: str  #: of its page, which `tumble explain CODE` prints; "" if it has none
    text: str  #: the whole message with the source line and a caret


class SceneError(ValueError):
    """A scene that is not valid. `file`, `line` and `column` are those of the first error."""

    def __init__(self, message: str, diagnostics: list[Diagnostic]) -> None:
        super().__init__(message)
        self.diagnostics = diagnostics

    @property
    def file(self) -> str:
        """The file, or the name that the scene was given; "" if it is unknown."""
        return self.diagnostics[0].file if self.diagnostics else ""

    @property
    def line(self) -> int:
        """From 1; 0 if it is unknown."""
        return self.diagnostics[0].line if self.diagnostics else 0

    @property
    def column(self) -> int:
        """From 1, in bytes; 0 if it is unknown."""
        return self.diagnostics[0].column if self.diagnostics else 0

    def __reduce__(self) -> tuple[type[SceneError], tuple[str, list[Diagnostic]]]:
        return SceneError, (str(self), self.diagnostics)


class SnapshotError(ValueError):
    """Bytes that are not a snapshot of this version, or not of this scene."""


class SimulationDiverged(RuntimeError):
    """A pose or a velocity is not finite any more. The world can be read, but not stepped."""

    def __init__(self, message: str, body: int, step: int) -> None:
        super().__init__(message)
        self.body = body  #: the id of the body
        self.step = step  #: the number of the step

    def __reduce__(self) -> tuple[type[SimulationDiverged], tuple[str, int, int]]:
        return SimulationDiverged, (str(self), self.body, self.step)


class InUseError(RuntimeError):
    """Another thread is stepping this world, these environments or this video."""


class FileError(OSError):
    """A file that cannot be read or written."""


class RenderError(RuntimeError):
    """Frames cannot be drawn on this machine: there is no OSMesa and no EGL, or no font."""
