#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nothing holds the GIL while it computes: Python goes on beside a long call, and two calls in two threads give what they give
one after the other."""
import threading
import time
import unittest

import numpy as np
import triax
from program import SAMPLES, InAFolder


def many_points(count):
    return triax.Points(triax.Material("sanisand/S28-general"), np.full((count, 2), 100.0), np.linspace(0.75, 0.95, count))


class Threads(InAFolder):
    def share_without_python(self, work):
        """The share of the time in which a loop of Python stood still for more than 20 ms at a time (four times the interval at
        which Python changes threads) beside `work`, repeated for at least 0.3 s so that a faster machine measures as well."""
        end = time.monotonic() + 0.3

        def repeat():
            work()
            while time.monotonic() < end:
                work()

        thread = threading.Thread(target=repeat)
        begin = last = time.monotonic()
        still = 0
        thread.start()
        while thread.is_alive():
            now = time.monotonic()
            still += now - last if now - last > 0.02 else 0
            last = now
        return still / (last - begin)

    def test_what_holds_the_gil_is_seen(self):
        self.assertGreater(self.share_without_python(lambda: sum(range(20_000_000))), 0.5)

    def test_python_goes_on_beside_every_computation(self):
        points = many_points(100_000)
        for void_ratio in (0.92, 0.96, 1.0):
            triax.simulate(SAMPLES / "programmes/icu_dense.toml", self.db, sets={"specimen.void_ratio": void_ratio})
        for work in (lambda: points.advance([1e-4, -0.5e-4]),
                     lambda: triax.simulate(SAMPLES / "programmes/icu_dense.toml", self.db),
                     lambda: triax.domain("inl2/S28-general", 1.086, p_kPa=(10, 300, 40), q_kPa=(0, 300, 60), directions=144, threads=1),
                     lambda: [triax.soil(self.db) for _ in range(20)],
                     lambda: triax.calibrate(self.db, "sanisand", free=["critical_stress_ratio"], searches=1)):
            self.assertLess(self.share_without_python(work), 0.5)

    def test_two_threads_give_what_one_gives(self):
        material = triax.Material("sanisand/S28-general")
        alone, one, two = (triax.Points(material, np.full((4_000, 2), 100.0), 0.8) for _ in range(3))

        def shear(points):
            for _ in range(3):
                points.advance([1e-4, -0.5e-4])

        shear(alone)
        threads = [threading.Thread(target=shear, args=(p,)) for p in (one, two)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        for points in (one, two):
            np.testing.assert_array_equal(points.stress_kPa, alone.stress_kPa)
            np.testing.assert_array_equal(points.memory, alone.memory)

    def test_what_is_read_of_points_that_advance_is_one_state(self):
        points = triax.Points(triax.Material("sanisand/S28-general"), np.full((20_000, 2), 100.0), 0.8)
        thread = threading.Thread(target=lambda: [points.advance([1e-4, -0.5e-4]) for _ in range(3)])
        thread.start()
        read = 0
        while thread.is_alive() or read == 0:
            self.assertEqual(np.ptp(points.copy().stress_kPa, axis=0).max(), 0)
            self.assertEqual(np.ptp(points.p_kPa), 0)
            self.assertEqual(np.ptp(points.q_kPa), 0)
            read += 1
        thread.join()

    def test_one_test_is_loaded_from_two_threads(self):
        triax.replay(SAMPLES / "records/icu_6.csv", self.db)
        test = triax.Database(self.db)[1]
        seen = []
        threads = [threading.Thread(target=lambda: seen.append(test.states)) for _ in range(4)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        self.assertEqual(len(seen), 4)
        self.assertTrue(all(np.shares_memory(s.q_kPa, seen[0].q_kPa) for s in seen))


if __name__ == "__main__":
    unittest.main()
