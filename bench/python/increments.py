#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""increments.py POINTS ROUNDS: what bench_cpp_loop does, by one call of Points.advance for all points."""
import sys
import time

import numpy as np
import triax

count, rounds = map(int, sys.argv[1:])
material = triax.Material("sanisand/S28-general")
undrained = (np.zeros((2, 2)), [[1, 0], [1, 2]])
one = triax.Points(material, [[100, 100]], 0.8)
for _ in range(100):
    one.advance(control=undrained, increment=[0.02 / 100, 0], tolerance=1e-6)
start = triax.Points(material, np.repeat(one.stress_kPa, count, axis=0), one.void_ratio[0] + 1e-5 * (np.arange(count) % 1000))
start.memory[:] = one.memory
for _ in range(rounds):
    points = start.copy()
    begin = time.thread_time_ns()
    points.advance([2e-5, -1e-5], tolerance=1e-6)
    print(f"{(time.thread_time_ns() - begin) / count:.1f} {points.stress_kPa.sum():.9g}", flush=True)
