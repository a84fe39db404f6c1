"""Random sequences of calls, right and wrong: each ends with a value or with an exception of the package."""

import copy
import os
import pickle

import numpy as np
import pytest

import tumble

#: Sequences of calls; tools/test.sh runs them with the address sanitizer too.
SEQUENCES = int(os.environ.get("TUMBLE_SEQUENCES", "150"))
CALLS = 40

#: What a call may raise. SimulationDiverged and SceneError are among them.
ALLOWED = (ValueError, TypeError, IndexError, OverflowError, RuntimeError, AttributeError, KeyError)


class Fuzzer:
    """A world, what was created in it (dead or alive), and views that are kept."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)
        self.worlds = [tumble.World()]
        self.bodies, self.shapes, self.joints, self.kept = [], [], [], []

    def pick(self, values):
        return values[int(self.random.integers(len(values)))] if len(values) else None

    def number(self):
        return self.pick([0.0, 1.0, -1.0, float(self.random.normal()), float(self.random.uniform(0, 5)), 1e3, 1e-6, 1e30,
                          float("nan"), float("inf"), -0.0, 3, None, "x"]) if self.random.random() < 0.3 else float(
                              self.random.uniform(0.1, 3))  # fmt: skip

    def vector(self):
        choice = self.random.random()
        if choice < 0.05:
            return self.pick([(), (1,), (1, 2, 3), "ab", 7, None, np.zeros((2, 2)), [float("nan"), 0]])
        if choice < 0.15:
            return (self.number(), self.number())
        return (float(self.random.uniform(-5, 5)), float(self.random.uniform(-5, 5)))

    def shape(self):
        makers = [lambda: tumble.circle(self.number()), lambda: tumble.box(self.number(), self.number()),
                  lambda: tumble.capsule(self.vector(), self.vector(), self.number()),
                  lambda: tumble.polygon([self.vector() for _ in range(int(self.random.integers(0, 7)))])]  # fmt: skip
        return self.pick(makers)()

    def world(self):
        return self.pick(self.worlds)

    def body(self):
        return self.pick(self.bodies) if self.bodies and self.random.random() < 0.95 else None

    def create(self):
        kind = self.pick(["dynamic", "dynamic", "dynamic", "static", "kinematic", "ghost"])
        shapes = [self.shape() for _ in range(int(self.random.integers(0, 3)))]
        self.bodies.append(self.world().add_body(kind, shapes=shapes, position=self.vector(), angle=self.number()))

    def attach(self):
        self.shapes.append(self.body().add_shape(self.shape(), density=self.number()))

    def chain(self):
        self.shapes += self.body().add_chain([self.vector() for _ in range(int(self.random.integers(0, 9)))])

    def join(self):
        kind = self.pick(["revolute", "prismatic", "distance", "weld", "wheel", "mouse", "gear", "rope"])
        members = self.pick([{}, {"anchor": self.vector()}, {"limits": self.vector()}, {"motor": self.vector()},
                             {"axis": self.vector(), "anchor": self.vector()}, {"spring": self.vector()}])  # fmt: skip
        self.joints.append(self.world().add_joint(kind, self.body(), self.body(), **members))

    def use_any(self, things):
        """Reads, sets or calls a random public member with random arguments."""
        thing = self.pick(things)
        names = [name for name in dir(type(thing)) if not name.startswith("_")]
        name = self.pick(names)
        member = getattr(type(thing), name)
        if isinstance(member, property):
            if member.fset is not None and self.random.random() < 0.5:
                setattr(thing, name, self.pick([self.number(), self.vector(), True, None]))
            else:
                self.kept.append(getattr(thing, name))
        elif name not in ("render", "step"):
            arguments = [self.pick([self.number, self.vector, self.body])() for _ in range(int(self.random.integers(0, 3)))]
            getattr(thing, name)(*arguments)

    def step(self):
        self.world().step(self.pick([0, 1, 1, 2, 5, -1, "1"]))

    def ask(self):
        world = self.world()
        self.pick([lambda: world.cast_ray(self.vector(), self.vector()),
                   lambda: world.cast_rays([self.vector() for _ in range(3)], [self.vector() for _ in range(3)]),
                   lambda: world.cast_shape(self.shape(), self.vector(), self.vector()),
                   lambda: world.overlap(self.shape(), self.vector(), self.number()),
                   lambda: world.closest(self.vector(), self.number()),
                   lambda: world.distance(self.body(), self.body()),
                   lambda: world.body(int(self.random.integers(-3, 40))),
                   lambda: tumble.distance(self.shape(), self.shape(), position_b=self.vector())])()  # fmt: skip

    def view(self):
        world = self.world()
        self.kept.append(self.pick([lambda: world.positions, lambda: world.angles, lambda: world.velocities,
                                    lambda: world.angular_velocities, lambda: world.contacts, lambda: world.ids,
                                    lambda: world.events])())  # fmt: skip

    def duplicate(self):
        world = self.world()
        self.worlds.append(self.pick([world.copy, lambda: pickle.loads(pickle.dumps(world)), lambda: copy.deepcopy(world),
                                      lambda: tumble.World.load(world.save()), tumble.World])())  # fmt: skip

    def damage(self):
        saved = bytearray(self.world().save())
        for _ in range(3):
            saved[int(self.random.integers(len(saved)))] ^= int(self.random.integers(1, 256))
        tumble.World.load(bytes(saved[: int(self.random.integers(len(saved) + 1))]))

    def forget(self):
        if len(self.worlds) > 1:
            self.worlds.pop(int(self.random.integers(len(self.worlds))))

    def call(self):
        calls = [self.create] * 5 + [self.attach, self.chain, self.join, self.join, self.step, self.step, self.step,
                 self.ask, self.ask, self.view, self.view, self.duplicate, self.damage, self.forget,
                 lambda: self.use_any(self.bodies), lambda: self.use_any(self.bodies), lambda: self.use_any(self.joints),
                 lambda: self.use_any(self.shapes), lambda: self.use_any(self.worlds)]  # fmt: skip
        self.pick(calls)()

    def finish(self):
        """Whatever was called, worlds that have not diverged are whole, and kept arrays can be read."""
        for world in self.worlds:
            try:
                world.step()
            except tumble.SimulationDiverged:
                continue
            world.audit()
            assert tumble.World.load(world.save()).state_hash == world.state_hash
        self.worlds.clear()
        self.bodies.clear()
        for kept in self.kept:
            if isinstance(kept, np.ndarray):
                kept.tobytes()
            repr(kept)


@pytest.mark.parametrize("part", range(10))
def test_random_calls_raise_or_work(part):
    raised = 0
    for seed in range(part, SEQUENCES, 10):
        fuzzer = Fuzzer(seed)
        for _ in range(CALLS):
            try:
                fuzzer.call()
            except ALLOWED:
                raised += 1
        fuzzer.finish()
    assert raised > 0
