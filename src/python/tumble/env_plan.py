"""What a scene declares as its environment, with its names resolved to ids."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from tumble.scene import Run, Scene

_ACTIONS = ("force", "thrust", "torque", "motor_speed", "motor_effort", "velocity", "spin", "target")
_OF_A_JOINT = ("motor_speed", "motor_effort", "target")
_OF_BODY = ("x", "y", "angle", "velocity_x", "velocity_y", "angular_velocity")
_OF_JOINT = {"position": 6, "speed": 7}
_TOUCHING, _RAY, _VALUE = 8, 9, 10
_RANDOM = ("x", "y", "angle", "velocity_x", "velocity_y", "angular_velocity", "gravity_scale", "impulse_x", "impulse_y",
           "mass", "friction", "restitution")  # fmt: skip

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
        self.images: dict[str, dict[str, Any]] = {}
        for entry in declared.get("observations", []):
            self._observe(entry)
        self.randoms = [self._random(entry) for entry in declared.get("random", [])]
        self.steps = int(declared.get("steps", 0))
        self.frame_skip = int(declared.get("frame_skip", 1))
        self.action_names = [str(entry.get("name", i)) for i, entry in enumerate(declared.get("actions", []))]
        self.reward = str(declared.get("reward", "0"))
        self.done = str(declared.get("done", "false"))
        if self.steps < 0 or self.frame_skip < 1:
            raise ValueError("custom.env: steps must be at least 0, and frame_skip at least 1")

    def resolved(self) -> dict[str, Any]:
        """For the C++ module, which compiles the expressions."""
        choices = [] if self.choices is None else self.choices.ravel().tolist()
        return {"actions": self.actions, "choices": choices, "observations": self.observations, "randoms": self.randoms,
                "images": list(self.images.values()),
                "observation_names": self.names, "action_names": self.action_names, "reward": self.reward,
                "done": self.done, "frame_skip": self.frame_skip, "steps": self.steps}  # fmt: skip

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
        table = "joint" if kind in _OF_A_JOINT else "body"
        plan[table] = self._joint(entry[kind]) if table == "joint" else self._body(entry[kind])
        plan["speed"] = float(entry.get("speed", 0.0))
        plan["axis"] = tuple(map(float, entry.get("axis", (1, 0))))
        plan["point"] = tuple(map(float, entry.get("point", (0, 0))))
        return plan

    def image_shape(self, name: str) -> tuple[tuple[int, ...], Any]:
        """The shape and the type of an image: pixels [height, width, 3], or labels [height, width]."""
        image = self.images[name]
        size = (int(image["rows"]), int(image["columns"]))
        return (size, np.uint16) if image["is_mask"] else ((*size, 3), np.uint8)

    @property
    def labels(self) -> dict[str, int]:
        """The numbers of bodies in masks; 0 is no body."""
        return {name: (body & 0xFFFFFFFF) + 1 for name, body in self._bodies.items()}

    def _see(self, kind: str, entry: Mapping[str, Any]) -> None:
        name = str(entry.get("name", kind))
        if name in self.images or name == "state":
            raise ValueError(f"custom.env: an image cannot be called '{name}'")
        try:
            columns, rows = map(int, entry[kind])
        except (TypeError, ValueError):
            columns = rows = 0
        if not (16 <= columns <= 8192 and 16 <= rows <= 8192):
            raise ValueError(f"custom.env: {kind} must be [width, height], each 16 to 8192, got {entry[kind]}")
        image: dict[str, Any] = {"is_mask": kind == "mask", "columns": columns, "rows": rows}
        if "center" in entry:
            image["center"] = tuple(map(float, entry["center"]))
        if "height" in entry:
            image["height"] = float(entry["height"])
            if not 0 < image["height"] < np.inf:
                raise ValueError(f"custom.env: the height of an image must be above 0, got {entry['height']}")
        if "follow" in entry:
            self._body(entry["follow"])
            image["follow"] = str(entry["follow"])
        self.images[name] = image

    def _observe(self, entry: Mapping[str, Any]) -> None:
        for kind in ("pixels", "mask"):
            if kind in entry and "rays" not in entry:  # rays have a mask of categories
                return self._see(kind, entry)
        scaled = {"scale": float(entry.get("scale", 1.0)), "offset": float(entry.get("offset", 0.0))}
        name = str(entry.get("name", f"observation_{len(self.names)}"))
        if "rays" in entry:
            ways = self._ways(entry)
            body = self._body(entry["rays"])
            for i, way in enumerate(ways):
                self.names.append(f"{name}_{i}")
                self.observations.append({"kind": _RAY, "body": body, "axis": way, **scaled,
                                          "point": tuple(map(float, entry.get("point", (0, 0)))),
                                          "turns": bool(entry.get("turns", False)),
                                          "mask": int(entry.get("mask", 0xFFFFFFFFFFFFFFFF))})  # fmt: skip
            return
        self.names.append(name)
        if "touches" in entry:
            one, *other = entry["touches"] if isinstance(entry["touches"], list) else [entry["touches"]]
            plan: dict[str, Any] = {"kind": _TOUCHING, "body": self._body(one), **scaled}
            if other:
                plan["other"] = self._body(other[0])
        elif "value" in entry:
            plan = {"kind": _VALUE, "expression": str(entry["value"]), **scaled}
        elif "joint" in entry and entry.get("of") in _OF_JOINT:
            plan = {"kind": _OF_JOINT[entry["of"]], "joint": self._joint(entry["joint"]), **scaled}
        elif "body" in entry and entry.get("of") in _OF_BODY:
            plan = {"kind": _OF_BODY.index(entry["of"]), "body": self._body(entry["body"]), **scaled}
        else:
            raise ValueError(f"custom.env: an observation needs body and of ({', '.join(_OF_BODY)}), joint and of "
                             f"({', '.join(_OF_JOINT)}), touches, rays, value, pixels or mask, got {dict(entry)}")  # fmt: skip
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
