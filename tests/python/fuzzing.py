"""Random calls, right and wrong, on a small world, a run, environments, distances and pictures."""

import copy
import math
import pickle
import random
import threading

import numpy as np

import tumble
import tumble.env

#: What a wrong call may raise. SceneError and SnapshotError are ValueErrors.
ALLOWED = (ValueError, TypeError, IndexError, tumble.SimulationDiverged)

#: Members that are not called with random arguments: steps may be many, frames large, and threads many.
LEFT_OUT = {"step", "render", "finish", "run", "start", "save", "load", "threads"}

NUMBERS = [0.0, 1.0, -1.0, 1e3, 1e-6, 1e30, 3e38, math.nan, math.inf, -0.0, 3, 2**31, 2**70, 10**400, None, "x", [], True]
VECTORS = [(), (1,), (1, 2, 3), "ab", 7, None, np.zeros((2, 2)), [math.nan, 0], {"x": 1}, (10**400, 0), (None, None)]

SCENE = {
    "format": 1, "world": {"duration": 0.5},
    "bodies": [{"name": "floor", "type": "static", "shapes": [{"box": {"size": [9, 1]}}]},
               {"name": "ball", "position": [0, 2], "shapes": [{"circle": {"radius": 0.5}}]}],
    "joints": [{"name": "rod", "type": "distance", "bodies": ["floor", "ball"], "anchors": [[0, 0], [0, 0]]}],
    "timeline": [{"at": 0.05, "body": "ball", "impulse": [1, 0]},
                 {"every": 0.1, "spawn": {"name": "drop", "position": [2, 5], "shapes": [{"box": {"size": [1, 1]}}]}}],
    "expect": [{"body": "ball", "inside": [[-9, -9], [9, 9]]}],
    "custom": {"env": {
        "actions": [{"name": "push", "force": "ball", "range": [-5, 5]}],
        "observations": [{"name": "x", "body": "ball", "of": "x"}, {"name": "on", "touches": ["ball", "floor"]},
                         {"rays": "ball", "count": 3}, {"name": "weight", "contact_force": "ball"}],
        "reward": "x + weight", "done": "abs(x) > 3", "steps": 4,
        "random": [{"body": "ball", "of": "x", "range": [-1, 1]}]}},
}  # fmt: skip


class Fuzzer:
    """What was created (alive or destroyed), and arrays that are kept."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.worlds = [tumble.World()]
        self.bodies, self.shapes, self.joints, self.kept = [], [], [], []
        self.runs, self.envs = [], []

    def pick(self, values):
        return self.random.choice(values) if values else None

    def number(self):
        return self.pick(NUMBERS) if self.random.random() < 0.1 else self.random.uniform(0.1, 3)

    def vector(self):
        chance = self.random.random()
        if chance < 0.05:
            return self.pick(VECTORS)
        return (self.number(), self.number()) if chance < 0.1 else (self.random.uniform(-5, 5), self.random.uniform(-5, 5))

    def shape(self):
        kind = self.random.randrange(9)
        if kind == 8:
            return self.pick([None, 3, "circle"])
        if kind < 3:
            return tumble.circle(self.number())
        if kind < 6:
            return tumble.box(self.number(), self.number())
        if kind == 6:
            return tumble.capsule(self.vector(), self.vector(), self.number())
        return tumble.polygon([self.vector() for _ in range(self.random.randrange(7))])

    def world(self):
        return self.pick(self.worlds)

    def body(self):
        return self.pick(self.bodies) if self.random.random() < 0.95 else self.pick([None, 5, "ball"])

    # ---- A world ----

    def create(self):
        kind = self.pick(["dynamic", "dynamic", "dynamic", "static", "kinematic", "ghost", None])
        shapes = [self.shape() for _ in range(self.random.randrange(3))]
        self.bodies.append(self.world().add_body(kind, shapes=shapes, position=self.vector(), angle=self.number()))

    def attach(self):
        if self.bodies:
            self.shapes.append(self.pick(self.bodies).add_shape(self.shape(), density=self.number(), mask=self.number()))

    def chain(self):
        if self.bodies:
            self.shapes += self.pick(self.bodies).add_chain([self.vector() for _ in range(self.random.randrange(9))])

    def join(self):
        kind = self.pick(["revolute", "prismatic", "distance", "weld", "wheel", "mouse", "gear", "rope"])
        name = self.pick(["anchor", "limits", "motor", "axis", "spring", "joint_a", "joint_b", "length"])
        value = self.pick([self.vector(), self.number(), self.body(), self.pick(self.joints)])
        self.joints.append(self.world().add_joint(kind, self.body(), self.body(), **{name: value}))

    def use_any(self):
        """Reads, sets or calls a random public member with random arguments."""
        thing = self.pick(self.pick([self.bodies, self.bodies, self.joints, self.shapes, self.worlds, self.runs, self.envs]))
        if thing is None:
            return
        name = self.pick([name for name in dir(type(thing)) if not name.startswith("_") and name not in LEFT_OUT])
        member = getattr(type(thing), name)
        if not isinstance(member, property):
            if callable(member):
                getattr(thing, name)(*[self.argument() for _ in range(self.random.randrange(3))])
        elif member.fset is not None and self.random.random() < 0.5:
            setattr(thing, name, self.argument())
        else:
            self.kept.append(getattr(thing, name))

    def argument(self):
        return self.pick([self.number, self.vector, self.body])()

    def step(self):
        self.world().step(self.pick([0, 1, 1, 2, -1, "1", 1.5]))

    def step_all(self):
        tumble.step_all(self.pick([self.worlds, self.worlds, [*self.worlds, 3], self.worlds * 2, self.bodies]),
                        self.pick([1, -1]), threads=self.pick([1, 2, 0]))  # fmt: skip

    def ask(self):
        world, exclude = self.world(), self.body() if self.random.random() < 0.5 else None
        self.kept.append(self.pick([
            lambda: world.cast_ray(self.vector(), self.vector(), exclude=exclude, mask=self.number()),
            lambda: world.cast_rays([self.vector() for _ in range(3)], [self.vector() for _ in range(3)], exclude=exclude),
            lambda: world.cast_shape(self.shape(), self.vector(), self.vector()),
            lambda: world.overlap(self.shape(), self.vector(), self.number(), exclude=exclude),
            lambda: world.closest(self.vector(), self.number()),
            lambda: world.distance(self.body(), self.body()),
            lambda: world.body(self.pick([0, 1, 2, -1, 7, 2**70, 0.5, None])),
        ])())  # fmt: skip

    def view(self):
        world = self.world()
        self.kept.append(getattr(world, self.pick(["positions", "angles", "velocities", "angular_velocities", "contacts",
                                                   "ids", "events"])))  # fmt: skip

    def duplicate(self):
        world = self.world()
        self.worlds.append(self.pick([world.copy, lambda: pickle.loads(pickle.dumps(world)), lambda: copy.deepcopy(world),
                                      tumble.World])())  # fmt: skip

    def damage(self):
        self.kept.append(tumble.World.load(self.damaged(self.world().save())))

    def damaged(self, saved):
        saved = bytearray(saved)
        for _ in range(3):
            saved[self.random.randrange(len(saved))] ^= self.random.randrange(1, 256)
        return bytes(saved[: self.random.randrange(len(saved) + 1)])

    def forget(self):
        if len(self.worlds) > 1:
            self.worlds.pop(self.random.randrange(len(self.worlds)))

    def two_threads(self):
        """One steps a world and reads it, while the other does the same: each works or is told that it is in use."""
        world, failures = self.world(), []

        def work():
            for _ in range(3):
                try:
                    world.step(2)
                    world.positions.sum()
                    world.save()
                except (tumble.InUseError, tumble.SimulationDiverged):
                    pass
                except BaseException as error:
                    failures.append(error)

        threads = [threading.Thread(target=work) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert not failures, failures

    # ---- Distances, scenes, environments, pictures ----

    def measure(self):
        shapes = [self.shape() for _ in range(3)]
        poses = [[self.number() for _ in range(self.pick([2, 3, 4]))] for _ in range(self.pick([1, 3]))]
        self.kept.append(self.pick([
            lambda: tumble.distance(self.shape(), self.shape(), position_b=self.vector()),
            lambda: tumble.trace_distance(self.shape(), self.shape(), angle_b=self.number()),
            lambda: tumble.distances(shapes, poses, self.shape(), poses),
            lambda: tumble.distances(iter(shapes), poses, shapes[0], (0, 0, 0)),
        ])())  # fmt: skip

    def changed_scene(self):
        """The scene with one value or key changed, of any depth."""
        data = copy.deepcopy(SCENE)
        parent, key = data, self.pick(list(data))
        while isinstance(parent[key], (dict, list)) and len(parent[key]) and self.random.random() < 0.8:
            parent = parent[key]
            key = self.pick(list(parent)) if isinstance(parent, dict) else self.random.randrange(len(parent))
        chance = self.random.random()
        if chance < 0.5:
            parent[key] = self.argument()
        elif chance < 0.75 and isinstance(parent, dict):
            parent[str(key) + "s"] = parent.pop(key)
        elif chance < 0.9:
            del parent[key]
        return tumble.Scene(data)

    def read_scene(self):
        scene = self.changed_scene()
        self.pick([scene.validate, scene.to_json, lambda: scene.hash, scene.copy])()
        self.runs.append(scene.start())

    def run(self):
        run = self.pick(self.runs)
        if run is None:
            self.runs.append(tumble.Scene(SCENE).start())
            return
        self.kept.append(self.pick([
            lambda: run.step(self.pick([1, 3, -1, "x"])), lambda: run.finish() if run.time < 1 else None,
            lambda: self.bodies.extend(run.bodies.values()), lambda: self.joints.extend(run.joints.values()),
            lambda: run.claims, lambda: run.value(self.pick(["ball.x", "ball.y > 1", "ball", "drop[0].x", "1 +", "", 3])),
            lambda: self.worlds.append(run.world), lambda: self.runs.append(run.copy()), lambda: pickle.dumps(run),
            lambda: tumble.Run.load((run.save()[0], self.damaged(run.save()[1]), self.damaged(run.save()[2]))),
        ])())  # fmt: skip

    def environment(self):
        scene = tumble.Scene(SCENE) if self.random.random() < 0.5 else self.changed_scene()
        self.envs.append(tumble.env.VectorEnv(scene, self.pick([1, 2, 3, 0, -1, "2"]), threads=self.pick([1, 1, 2, 0])))

    def act(self):
        envs = self.pick(self.envs)
        if envs is None:
            self.envs.append(tumble.env.VectorEnv(tumble.Scene(SCENE), 2, threads=1))
            return
        shape = (envs.count, len(envs.plan.actions))
        actions = [np.zeros(shape), np.ones(shape, int), np.full(shape, math.nan), np.zeros((1, 9)), None, "up", [self.number()]]
        self.kept.append(self.pick([
            lambda: envs.reset(), lambda: envs.reset(seed=self.pick([1, -1, "x", 2**70])),
            lambda: envs.step(self.pick(actions)), lambda: envs.step(np.zeros(shape)), lambda: envs.step(np.zeros(shape)),
            lambda: envs.world(self.pick([0, 1, 9, -1])), lambda: envs.state_hash(self.pick([0, 9, "x"])),
        ])())  # fmt: skip

    def draw(self):
        what = self.pick([*self.worlds, *self.runs])
        self.kept.append(tumble.render(what, self.pick([32, 32, 3, -1, 10**9, "x"]), 32, center=self.vector(),
                                       view_height=self.number(), overlay=self.pick([(), ["contacts"], ["x"], "x"]),
                                       theme=self.pick([None, "dark", "x", 3])))  # fmt: skip

    def call(self, draws):
        calls = [(self.create, 12), (self.attach, 3), (self.chain, 2), (self.join, 4), (self.step, 6), (self.ask, 5),
                 (self.view, 4), (self.duplicate, 2), (self.damage, 1), (self.forget, 1), (self.use_any, 12),
                 (self.step_all, 1), (self.measure, 3), (self.read_scene, 1), (self.run, 4), (self.environment, 1),
                 (self.act, 4), (self.two_threads, 0.2), (self.draw, 1 if draws else 0)]  # fmt: skip
        self.random.choices([call for call, _ in calls], [weight for _, weight in calls])[0]()

    def finish(self):
        """Whatever was called, worlds that have not diverged are whole, and kept arrays can be read."""
        world = self.world()
        try:
            world.step()
        except tumble.SimulationDiverged:
            pass
        else:
            world.audit()
            assert tumble.World.load(world.save()).state_hash == world.state_hash
        self.worlds.clear(), self.bodies.clear(), self.runs.clear(), self.envs.clear()
        for kept in self.kept:
            if isinstance(kept, np.ndarray):
                kept.tobytes()
