"""What a scene declares as its environment, with its names resolved to ids."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tumble.env_entry import Entry
from tumble.scene import Run, Scene

_MEMBERS = ("actions", "choices", "observations", "reward", "done", "steps", "random", "frame_skip")

# The kinds in the order of ActionKind, with the members that each has besides `name` and `range`.
_ACTIONS = {"force": ("axis",), "thrust": ("axis", "point"), "torque": (), "motor_speed": (), "motor_effort": ("speed",),
            "velocity": ("axis",), "spin": (), "target": ("axis", "point")}  # fmt: skip
_OF_A_JOINT = ("motor_speed", "motor_effort", "target")

# The numbers of ObservedKind.
_OF_BODY = {"x": 0, "y": 1, "angle": 2, "velocity_x": 3, "velocity_y": 4, "angular_velocity": 5}
_OF_JOINT = {"position": 6, "speed": 7}
_OF_CONTACTS = {"touches": 8, "contact_force": 11}
_RAY, _VALUE = 9, 10

# What identifies an observation, with the other members that it has besides `name`, `offset` and `scale`. Of a ray,
# `mask` has categories.
_OBSERVATIONS = {"rays": ("angles", "count", "length", "point", "turns", "mask"), "touches": (), "contact_force": (),
                 "value": (), "joint": ("of",), "body": ("of",)}  # fmt: skip
_IMAGES = ("pixels", "mask")

# In the order of RandomKind.
_RANDOM = ("x", "y", "angle", "velocity_x", "velocity_y", "angular_velocity", "gravity_scale", "impulse_x", "impulse_y",
           "mass", "friction", "restitution")  # fmt: skip

_ALL_CATEGORIES = 0xFFFFFFFFFFFFFFFF
_MOST_RAYS = 10000

Rows = npt.NDArray[np.float32]


class Plan:
    """The environment that a scene declares, with its names resolved to ids. Raises SceneError with the wrong line."""

    def __init__(self, scene: Scene) -> None:
        custom = scene._plain().get("custom")
        if not isinstance(custom, dict) or "env" not in custom:
            raise ValueError(f"{scene!r} declares no environment: it needs custom.env")
        self._declared = declared = Entry(scene, custom["env"], "", "env")
        declared.allow(_MEMBERS)
        self._places = scene._places()
        run = Run(scene)
        self.start = run.world
        self._bodies = {name: body.id for name, body in run.bodies.items()}
        self._joints = {name: joint.id for name, joint in run.joints.items()}
        actions = list(declared.entries("actions", "an action"))
        self.actions = [self._action(entry) for entry in actions]
        self.action_names = [entry.text("name", str(i)) for i, entry in enumerate(actions)]
        self.choices = self._choices() if "choices" in declared else None
        self.names: list[str] = []  #: of the observations that are numbers
        self.observations: list[dict[str, Any]] = []
        self.images: dict[str, dict[str, Any]] = {}
        for entry in declared.entries("observations", "an observation"):
            self._observe(entry)
        self.randoms = [self._random(entry) for entry in declared.entries("random", "an entry of random")]
        self.steps = declared.whole("steps", 0, 0, 2**53)
        self.frame_skip = declared.whole("frame_skip", 1, 1, 10**6)
        self.reward = declared.text("reward", "0")
        self.done = declared.text("done", "false")

    def resolved(self) -> dict[str, Any]:
        """For the C++ module, which compiles the expressions."""
        choices = [] if self.choices is None else self.choices.ravel().tolist()
        text, file = self._places
        return {"actions": self.actions, "choices": choices, "observations": self.observations, "randoms": self.randoms,
                "images": list(self.images.values()), "observation_names": self.names,
                "action_names": self.action_names, "reward": self.reward, "done": self.done,
                "frame_skip": self.frame_skip, "steps": self.steps, "text": text, "file": file}  # fmt: skip

    def image_shape(self, name: str) -> tuple[tuple[int, ...], Any]:
        """The shape and the type of an image: pixels [height, width, 3], or labels [height, width]."""
        image = self.images[name]
        size = (int(image["rows"]), int(image["columns"]))
        return (size, np.uint16) if image["is_mask"] else ((*size, 3), np.uint8)

    @property
    def labels(self) -> dict[str, int]:
        """The numbers of bodies in masks; 0 is no body."""
        return {name: (body & 0xFFFFFFFF) + 1 for name, body in self._bodies.items()}

    @property
    def fps(self) -> float:
        """The actions in a second of simulated time."""
        return 1.0 / (self.start.dt * self.frame_skip)

    def _action(self, entry: Entry) -> dict[str, Any]:
        kinds = [kind for kind in _ACTIONS if kind in entry]
        if len(kinds) != 1:
            entry.refuse(f"an action needs one of {', '.join(_ACTIONS)}")
        kind = kinds[0]
        entry.allow(("name", "range", kind, *_ACTIONS[kind]))
        low, high = entry.pair("range", (-1, 1))
        of_joint = kind in _OF_A_JOINT
        return {"kind": list(_ACTIONS).index(kind), "low": low, "high": high, "pointer": entry.place,
                "joint" if of_joint else "body": self._joint(entry, kind) if of_joint else self._body(entry, kind),
                "speed": entry.number("speed") if kind == "motor_effort" else 0.0,
                "axis": entry.pair("axis", (1, 0)), "point": entry.pair("point", (0, 0))}  # fmt: skip

    def _choices(self) -> Rows:
        try:
            choices = np.asarray(self._declared.get("choices"), dtype=np.float32)
        except (TypeError, ValueError):
            choices = np.zeros(0, np.float32)
        if choices.ndim != 2 or choices.shape[0] < 1 or choices.shape[1] != len(self.actions):
            self._declared.refuse(f"choices must have the shape (n, {len(self.actions)})", "choices")
        return choices

    def _body(self, entry: Entry, name: str) -> int:
        return entry.name_in(self._bodies, name, "body")

    def _joint(self, entry: Entry, name: str) -> int:
        return entry.name_in(self._joints, name, "joint")

    def _observe(self, entry: Entry) -> None:
        kinds = [kind for kind in _OBSERVATIONS if kind in entry]
        images = [kind for kind in _IMAGES if kind in entry and "rays" not in entry]
        if len(kinds) + len(images) != 1:
            entry.refuse(f"an observation needs one of {', '.join((*_OBSERVATIONS, *_IMAGES))}")
        if images:
            return self._see(images[0], entry)
        kind = kinds[0]
        entry.allow(("name", "offset", "scale", kind, *_OBSERVATIONS[kind]))
        name = entry.text("name", f"observation_{len(self.names)}")
        if name in self.names:
            entry.refuse(f"there is an observation '{name}' already", "name")
        scaled = {"scale": entry.number("scale", 1.0), "offset": entry.number("offset", 0.0), "pointer": entry.place}
        if kind == "rays":
            rays = self._rays(entry)
            self.names += [f"{name}_{i}" for i in range(len(rays))]
            self.observations += [{**ray, **scaled} for ray in rays]
        else:
            self.names.append(name)
            self.observations.append({**self._measured(kind, entry), **scaled})

    def _measured(self, kind: str, entry: Entry) -> dict[str, Any]:
        if kind in _OF_CONTACTS:
            return self._contacts(kind, entry)
        if kind == "value":
            return {"kind": _VALUE, "expression": entry.text("value")}
        quantities = _OF_JOINT if kind == "joint" else _OF_BODY
        part = self._joint(entry, "joint") if kind == "joint" else self._body(entry, "body")
        return {"kind": entry.name_in(quantities, "of", f"quantity of a {kind}"), kind: part}

    def _contacts(self, kind: str, entry: Entry) -> dict[str, Any]:
        named = entry.get(kind)
        if not isinstance(named, list):
            return {"kind": _OF_CONTACTS[kind], "body": self._body(entry, kind)}
        if len(named) != 2:
            entry.refuse(f"{kind} must be a body, or a list of two", kind)
        one, other = (entry.name_in(self._bodies, kind, "body", value=body or "?") for body in named)
        return {"kind": _OF_CONTACTS[kind], "body": one, "other": other}

    def _rays(self, entry: Entry) -> list[dict[str, Any]]:
        body = self._body(entry, "rays")
        first, last = np.radians(entry.pair("angles", (0, 360)))
        count = entry.whole("count", 1, 1, _MOST_RAYS)
        length = entry.number("length", 10.0)
        if length <= 0:
            entry.refuse(f"length must be above 0, got {length}", "length")
        shared = {"kind": _RAY, "body": body, "point": entry.pair("point", (0, 0)), "turns": entry.truth("turns", False),
                  "mask": entry.whole("mask", _ALL_CATEGORIES, 0, _ALL_CATEGORIES)}  # fmt: skip
        return [{**shared, "axis": (length * float(np.cos(angle)), length * float(np.sin(angle)))}
                for angle in np.linspace(first, last, count)]  # fmt: skip

    def _see(self, kind: str, entry: Entry) -> None:
        entry.allow(("name", kind, "center", "height", "follow"))
        name = entry.text("name", kind)
        if name in self.images or name == "state":
            entry.refuse(f"an image cannot be called '{name}'")
        columns, rows = entry.pair(kind)
        if not all(16 <= side <= 8192 and side == int(side) for side in (columns, rows)):
            entry.refuse(f"{kind} must be [width, height], each 16 to 8192, got {entry.get(kind)}", kind)
        image: dict[str, Any] = {"is_mask": kind == "mask", "columns": int(columns), "rows": int(rows)}
        if "center" in entry:
            image["center"] = entry.pair("center")
        if "height" in entry:
            image["height"] = entry.number("height")
            if image["height"] <= 0:
                entry.refuse(f"the height of an image must be above 0, got {image['height']}", "height")
        if "follow" in entry:
            self._body(entry, "follow")
            image["follow"] = entry.text("follow")
        self.images[name] = image

    def _random(self, entry: Entry) -> dict[str, Any]:
        entry.allow(("body", "of", "range"))
        low, high = entry.pair("range")
        kinds = {name: i for i, name in enumerate(_RANDOM)}
        return {"kind": entry.name_in(kinds, "of", "random quantity"), "body": self._body(entry, "body"), "low": low,
                "high": high}  # fmt: skip
