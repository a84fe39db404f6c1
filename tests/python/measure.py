"""The rates of the package, beside those of C++: measure.py RATES, the library of rates.cpp. tools/python.sh --measure runs it.

Both sides take turns in this process, and each figure is a median. Times are those of the CPU, except where several cores
work.
"""

import ctypes
import os
import sys
import time
from pathlib import Path

import numpy as np

import tumble
import tumble.env

SCENES = Path(__file__).resolve().parents[2] / "scenes"
ROUNDS = 21


def seconds(call, clock=time.process_time):
    start = clock()
    call()
    return clock() - start


class Cpp:
    """The same work on a world in C++."""

    def __init__(self, library, world):
        self.library, saved = ctypes.CDLL(library), world.save()
        self.library.load.restype = ctypes.c_void_p
        self.world = ctypes.c_void_p(self.library.load(saved, ctypes.c_size_t(len(saved))))

    def run(self, work, repetitions):
        self.library.run(self.world, work.encode(), repetitions)


def beside(cpp, work, repetitions, call, rounds=ROUNDS):
    """The median seconds of one repetition in Python and in C++, and the median of the ratios of neighbours."""
    sides = [lambda: call(repetitions), lambda: cpp.run(work, repetitions)]
    pairs = []
    for i in range(rounds):  # each goes first in half of the rounds
        first = seconds(sides[i % 2])
        pairs.append((first, seconds(sides[1 - i % 2]))[:: 1 - 2 * (i % 2)])
    ours, theirs = np.array(pairs).T
    return np.median(ours) / repetitions, np.median(theirs) / repetitions, np.median(ours / theirs)


def show(name, figure, bar):
    print(f"{name:<66} {figure:<34} {bar}", flush=True)


def steps(world, count):
    for _ in range(count):
        world.step()


def many_bodies():
    world = tumble.World(gravity=(0, 0))
    for i in range(10000):
        world.add_body(shapes=[tumble.circle(0.4)], position=(i % 100, i // 100))
    world.step()
    return world


def pairs_of_boxes(count=1_000_000):
    """Those of rates.cpp."""
    turn, angle = 1e-3 * np.arange(count), 7e-4 * np.arange(count)
    poses = np.column_stack([2.4 * np.cos(turn), 2.4 * np.sin(turn), np.cos(angle), np.sin(angle)])
    return tumble.box(2, 1), (0, 0, 1, 0), tumble.box(1, 1, radius=0.1), poses


def env_rate(name, count, threads, actions, repetitions):
    envs = tumble.env.make_vector(name, count, threads=threads)
    envs.reset(seed=1)
    chosen = [actions(np.random.default_rng(i), envs) for i in range(8)]
    clock = time.process_time if threads == 1 else time.perf_counter
    taken = [seconds(lambda: [envs.step(chosen[i % 8]) for i in range(repetitions)], clock) for _ in range(ROUNDS)]
    return count * repetitions / np.median(taken)


def any_choice(random, envs):
    return random.integers(0, len(envs.plan.choices), envs.count)


def any_row(random, envs):
    return random.uniform(-1, 1, (envs.count, len(envs.plan.actions)))


def main(library):
    pyramid = tumble.World.load(tumble.Scene.load(SCENES / "large_pyramid.json").start().world.save())
    ours, theirs, ratio = beside(Cpp(library, pyramid), "step", 3, lambda n: steps(pyramid, n), 101)
    show("a step of large_pyramid", f"{ours * 1e6:.0f} us, C++ {theirs * 1e6:.0f} us, {ratio:.3f} x", "1.01 x")

    bodies = many_bodies()
    held = bodies.positions, bodies.angles
    view = np.median([seconds(lambda: [(bodies.positions, bodies.angles) for _ in range(10)]) for _ in range(101)]) / 10
    show("the poses of 10 000 bodies, as views", f"{view * 1e6:.1f} us", "20 us")
    del held

    def copies(count):
        for _ in range(count):
            first.velocity = (0, 0)  # so that the arrays are filled again
            bodies.positions.copy(), bodies.angles.copy()

    first = bodies.bodies[0]
    ours, theirs, _ = beside(Cpp(library, bodies), "poses", 20, copies)
    show("the same, filled after a step and copied", f"{ours * 1e6:.0f} us, C++ {theirs * 1e6:.0f} us", "200 us")

    pairs = pairs_of_boxes()
    ours, theirs, ratio = beside(Cpp(library, bodies), "distances", 1, lambda n: tumble.distances(*pairs), 9)
    show("a million distances through arrays", f"{1 / ours:.2f} M/s, C++ {1 / theirs:.2f} M/s, {100 / ratio:.0f} %", "60 %")

    cores = len(os.sched_getaffinity(0))
    rate = env_rate("cart_pole", 4096, cores, any_choice, 10)
    show(f"4096 cart-poles on {cores} cores, steps of environments", f"{rate / 1e6:.2f} M/s", "1 M/s on 2 cores")
    rate = env_rate("cart_pole", 4096, 1, any_choice, 10)
    show("the same on one core", f"{rate / 1e6:.2f} M/s", "")
    rate = env_rate("bipedal_walker", 256, 1, any_row, 10)
    show("walkers with ten rays on one core, steps of environments", f"{rate / 1e3:.0f} k/s", "100 k/s")

    walkers = tumble.env.make_vector("bipedal_walker", 256, threads=1)
    ours, theirs, _ = beside(Cpp(library, walkers.world()), "reset", 256, lambda n: walkers.reset())
    show("the reset of a walker, with its observation", f"{ours * 1e6:.1f} us, C++ {theirs * 1e6:.1f} us", "50 us")


if __name__ == "__main__":
    main(sys.argv[1])
