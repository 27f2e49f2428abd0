#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of a database as arrays: their values, and that they show memory which is not copied."""
import contextlib
import gc
import math
import sqlite3
import unittest

import numpy as np
import triax
from program import SAMPLES, InAFolder


class Tables(InAFolder):
    def setUp(self):
        super().setUp()
        self.test = triax.replay(SAMPLES / "records/icu_6.csv", self.db)

    def test_states_are_those_of_the_database(self):
        names = [n for n in self.test.states if n != "stage"]
        rows = triax.Database(self.db).query(f"SELECT {', '.join(names)} FROM states WHERE test_id = {self.test.id}")
        self.assertEqual(self.test.states.rows, len(rows))
        self.assertGreater(len(rows), 3000)
        for name in names:
            stored = np.array([math.nan if row[name] is None else row[name] for row in rows])
            np.testing.assert_allclose(self.test.states[name], stored, rtol=1e-15, atol=1e-12, err_msg=name)

    def test_readings_are_those_of_the_file(self):
        lines = [line for line in (SAMPLES / "records/icu_6.csv").read_text().splitlines() if line[:1] != "#"]
        heading, first, last = lines[0].split(","), lines[1].split(","), lines[-1].split(",")
        compared = 0
        for name, a, b in zip(heading, first, last):
            if name in self.test.readings and name != "reading":
                values = self.test.readings[name]
                np.testing.assert_allclose([values[0], values[-1]], [float(a), float(b)], rtol=1e-15, err_msg=name)
                compared += 1
        self.assertGreaterEqual(compared, 8)

    def test_both_instants_are_those_of_the_report(self):
        collapse = self.test.report["collapse"]
        self.assertEqual(self.test.onset["reading"], collapse["reading"])
        self.assertEqual(self.test.onset["eta_low"], collapse["eta_low"])
        self.assertEqual(self.test.onset["detected_at"], collapse["detected_at"])
        self.assertLess(self.test.loss_of_control["p_eff_kPa"], 1)  # a prescribed displacement: p' is zero
        dense = triax.simulate(SAMPLES / "programmes/icu_dense.toml", self.db)
        self.assertIsNone(dense.onset)
        self.assertIsNone(dense.loss_of_control)
        held = triax.simulate(SAMPLES / "programmes/csu_26.toml", self.db)
        self.assertEqual(held.loss_of_control, held.report["collapse"]["loss_of_control"])
        self.assertGreater(held.loss_of_control["reading"], held.onset["reading"])
        self.assertGreater(held.loss_of_control["q_kPa"], 0)
        self.assertGreaterEqual(held.loss_of_control["detected_at"]["reading"], held.loss_of_control["reading"])

    def test_work_is_negative_after_the_onset_only(self):
        work, onset = self.test.second_order_work, self.test.report["collapse"]["reading"]
        self.assertTrue((abs(work.normalised) <= 1).all())
        self.assertLess(work.normalised[work.reading > onset][5:25].max(), 0)

    def test_arrays_show_one_memory(self):
        one, two = self.test.states.q_kPa, self.test.states["q_kPa"]
        self.assertEqual(one.__array_interface__["data"][0], two.__array_interface__["data"][0])
        self.assertTrue(np.shares_memory(one, two))
        self.assertFalse(one.flags.owndata)
        self.assertIs(one.base, self.test.states)
        self.assertTrue(one.flags.c_contiguous and one.strides == (8,))
        self.assertFalse(np.shares_memory(one, self.test.states.p_eff_kPa))

    def test_arrays_outlive_test_and_database(self):
        q = self.test.states.q_kPa
        expected = q.copy()
        del self.test
        gc.collect()
        [np.empty(100_000) for _ in range(20)]  # what was freed would be taken
        np.testing.assert_array_equal(q, expected)

    def test_what_was_measured_is_not_written_to(self):
        with self.assertRaises(ValueError):
            self.test.readings.cell_pressure_kPa[0] = 0

    def test_a_column_that_is_not_there(self):
        with self.assertRaisesRegex(AttributeError, "unknown column 'q'; must be one of: reading, stage, time_s"):
            self.test.states.q
        with self.assertRaises(KeyError):
            self.test.states["q"]
        self.assertFalse(hasattr(self.test.states, "__wrapped__"))

    def test_a_table_is_a_mapping(self):
        table = self.test.states
        self.assertEqual(set(dict(table)), set(table))
        self.assertIn("eta", dir(table))

    def test_missing_readings_are_a_warning(self):
        with contextlib.closing(sqlite3.connect(self.db)) as database, database:
            database.execute("DELETE FROM scans WHERE id % 3 = 0")
        for call in (lambda: triax.Database(self.db), lambda: triax.soil(self.db)):
            with self.assertWarnsRegex(RuntimeWarning, "of its 3280 readings are missing"), contextlib.suppress(triax.BadInput):
                call()

    def test_finding_tests(self):
        triax.simulate(SAMPLES / "programmes/icu_dense.toml", self.db)
        database = triax.Database(self.db)
        self.assertEqual([t.name for t in database], ["ICU 6", "ICU dense"])
        self.assertEqual(len(database), 2)
        self.assertEqual(database["icu_dense"].id, 2)
        self.assertEqual(database[1].name, "ICU 6")
        with self.assertRaises(triax.BadInput):
            database[3]


if __name__ == "__main__":
    unittest.main()
