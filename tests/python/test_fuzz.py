"""Random sequences of calls, right and wrong: each ends with a value or with one of few exceptions."""

import os
import time

import pytest

from fuzzing import ALLOWED, Fuzzer

#: tools/test.sh runs them with the address sanitizer too.
SEQUENCES = int(os.environ.get("TUMBLE_SEQUENCES", "1000"))
CALLS = 20

#: Frames take longer than all other calls: one sequence in so many draws some.
DRAWING = 50

PARTS = 10


def is_raised(fuzzer, draws):
    try:
        fuzzer.call(draws)
    except ALLOWED:
        return True
    return False


@pytest.mark.parametrize("part", range(PARTS))
def test_random_calls_raise_or_work(part):
    raised, calls, start = 0, 0, time.perf_counter()
    for seed in range(part, SEQUENCES, PARTS):
        fuzzer = Fuzzer(seed)
        try:
            for _ in range(CALLS):
                calls += 1
                raised += is_raised(fuzzer, draws=seed % DRAWING == 0)
            fuzzer.finish()
        except Exception:
            print(f"sequence {seed}")
            raise
    print(f"{calls} calls in {time.perf_counter() - start:.1f} s, {raised} raised")
    assert 0.05 * calls < raised < 0.5 * calls
