#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""replay, simulate and element give what the program gives, refuse in its words, and heed Ctrl-C."""
import signal
import threading
import time
import unittest

import numpy as np
import triax
from program import SAMPLES, InAFolder, refusal, triax_json

PROGRAMME = SAMPLES / "programmes/icu_dense.toml"


class Runs(InAFolder):
    def test_a_record_gives_the_report_of_the_program(self):
        record = SAMPLES / "records/csd_58.csv"
        mine = triax.replay(record, self.db).report
        theirs = triax_json("replay", record, "--db", self.folder / "other.db", "--json")
        for report in (mine, theirs):
            report["test"].pop("stored_at")
        self.assertEqual(mine, theirs)

    def test_what_a_file_does_not_hold_is_given(self):
        record = SAMPLES / "dialects/my_lab_record.txt"
        test = triax.replay(record, self.db, dialect=str(SAMPLES / "dialects/my_lab.toml"),
                            sets={"specimen.height_mm": 141.5})
        self.assertEqual(test.report["specimen"]["height_mm"], 141.5)

    def test_the_membrane_is_corrected_for(self):
        with self.assertRaisesRegex(triax.BadInput, "membrane 'latex' is not valid; must be one of: none, astm, iso"):
            triax.replay(SAMPLES / "records/icu_6.csv", self.db, membrane="latex")

    def test_a_simulation_and_its_record_have_the_same_states(self):
        record = self.folder / "record.csv"
        simulated = triax.simulate(PROGRAMME, self.db, seed=7, record=record)
        replayed = triax.replay(record, self.db)
        for name in simulated.states:
            np.testing.assert_array_equal(simulated.states[name], replayed.states[name], err_msg=name)

    def test_changed_keys_are_in_the_name(self):
        theirs = triax_json("simulate", PROGRAMME, "--set", "seed=4", "--db", self.folder / "other.db", "--json")
        mine = triax.simulate(PROGRAMME, self.db, sets={"seed": 4})
        self.assertEqual(mine.name, theirs["test"]["name"])
        self.assertEqual(mine.report["peak"], theirs["peak"])

    def test_a_path_gives_the_rows_of_the_program(self):
        for path in ("icu_100", "load_beyond_limit", "simple_shear"):
            run = triax.element(SAMPLES / f"paths/{path}.toml")
            rows = run.report["rows"]
            self.assertEqual(run.rows.rows, len(rows))
            for name in run.rows:
                np.testing.assert_array_equal(run.rows[name], [np.nan if r[name] is None else r[name] for r in rows])
            self.assertEqual(run.segments, [r["segment"] for r in rows])
            self.assertEqual(run.completed, path != "load_beyond_limit")
            if run.completed:
                self.assertEqual(run.report, triax_json("element", SAMPLES / f"paths/{path}.toml", "--json"))
            else:
                self.assertEqual((1, run.message), refusal("element", SAMPLES / f"paths/{path}.toml"))

    def test_a_path_is_changed_by_sets(self):
        run = triax.element(SAMPLES / "paths/icu_100.toml", sets={"void_ratio": 1.05})
        self.assertEqual(run.rows.void_ratio[0], 1.05)

    def test_refusals_have_the_words_of_the_program(self):
        triax.replay(SAMPLES / "records/icu_6.csv", self.db)
        empty, missing = self.folder / "empty.csv", self.folder / "missing.csv"
        empty.write_text("")
        db = str(self.db)
        cases = [
            (lambda: triax.replay(missing, db), ("replay", missing, "--db", db)),
            (lambda: triax.replay(empty, db), ("replay", empty, "--db", db)),
            (lambda: triax.replay(SAMPLES / "records/icu_6.csv", db, sets={"specimen.colour": "red"}),
             ("replay", SAMPLES / "records/icu_6.csv", "--set", "specimen.colour=red", "--db", db)),
            (lambda: triax.simulate(PROGRAMME, db, sets={"specimen.void_ratio": -1}),
             ("simulate", PROGRAMME, "--set", "specimen.void_ratio=-1", "--db", db)),
            (lambda: triax.element(SAMPLES / "paths/icu_100.toml", sets={"colour": 1}),
             ("element", SAMPLES / "paths/icu_100.toml", "--set", "colour=1")),
            (lambda: triax.Database(missing), ("report", "--db", missing)),
            (lambda: triax.Database(db)["nobody"], ("report", "nobody", "--db", db)),
            (lambda: triax.Database(db).query("DELETE FROM tests"), ("query", "DELETE FROM tests", "--db", db)),
            (lambda: triax.Material("sanisand/S28-genral"), ("materials", "sanisand/S28-genral")),
        ]
        for call, arguments in cases:
            with self.subTest(arguments=arguments), self.assertRaises(triax.BadInput) as raised:
                call()
            self.assertEqual((2, str(raised.exception)), refusal(*arguments))
        self.assertIsInstance(raised.exception, ValueError)

    def test_ctrl_c_ends_a_simulation_and_keeps_its_readings(self):
        for attempt in range(10):  # it may come between two tests
            timer = threading.Timer(0.3 + 0.017 * attempt, lambda: signal.raise_signal(signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                for seed in range(200):
                    triax.simulate(PROGRAMME, self.db, seed=seed)
            timer.join()
            statuses = [t.status for t in triax.Database(self.db)]
            self.assertTrue(all(s == "complete" for s in statuses[:-1]))
            if statuses[-1] != "complete":
                break
        self.assertIn(statuses[-1], ("interrupted", "running"))  # without a sign of life

    def test_ctrl_c_ends_a_query_between_two_rows(self):
        triax.replay(SAMPLES / "records/icu_6.csv", self.db)
        many = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 50000000) SELECT i FROM n"
        seen = []

        def heed(number, frame):
            seen.append(number)
            raise KeyboardInterrupt

        usual = signal.signal(signal.SIGINT, heed)
        timer = threading.Timer(0.2, lambda: signal.raise_signal(signal.SIGINT))
        begin = time.monotonic()
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                triax.Database(self.db).query(many)
        finally:
            signal.signal(signal.SIGINT, usual)
        timer.join()
        self.assertEqual(seen, [signal.SIGINT])
        self.assertLess(time.monotonic() - begin, 5)  # fifty million rows take longer


if __name__ == "__main__":
    unittest.main()
