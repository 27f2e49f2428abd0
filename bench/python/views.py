#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""views.py RECORD [--labels]: replays a long record into a database and prints how long its states take to come to Python."""
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import triax

labels = "--labels" in sys.argv


def told(what, seconds, unit=1e3):
    print(f"{what:<70}{'#' if labels else f'{seconds * unit:.3f}':>10} ms")


def least(work, repetitions=1 if labels else 7):
    taken = []
    for _ in range(repetitions):
        begin = time.perf_counter()
        work()
        taken.append(time.perf_counter() - begin)
    return min(taken)


with tempfile.TemporaryDirectory() as folder:
    db = Path(folder) / "long.db"
    test = triax.replay(sys.argv[1], db, sets={"specimen.height_mm": 140, "specimen.diameter_mm": 70})
    begin = time.perf_counter()
    states = test.states
    first = time.perf_counter() - begin
    size = states.rows * len(states) * 8 / 1e6
    print(f"{'#' if labels else states.rows} readings, {len(states)} columns of states, {'#' if labels else f'{size:.0f}'} MB")
    told("read from the database, once a test", first)
    again = least(lambda: [test.states[name] for name in test.states])
    told("all columns as arrays, once they are read", again)
    told("sum of one column", least(lambda: test.states.q_kPa.sum()))
    np.save(f"{folder}/states.npy", np.column_stack([test.states[name] for name in test.states]))
    mapped = least(lambda: np.load(f"{folder}/states.npy", mmap_mode="r"))
    told("the same saved by numpy.save, mapped by numpy.load(mmap_mode='r')", mapped)
    assert np.shares_memory(test.states.q_kPa, test.states.q_kPa)
    if not labels and max(again, mapped) > 0.010:
        sys.exit("views: more than 10 ms")
