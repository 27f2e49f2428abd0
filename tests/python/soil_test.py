#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""soil and calibrate give what the program gives, refuse in its words, and end on Ctrl-C with the best so far."""
import signal
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np
import triax
from program import SAMPLES, InAFolder, refusal, triax_json

PROGRAMMES = SAMPLES / "programmes"
SAND = {"specimen.material": "sanisand/S28-general", "rig.frame.travel_mm": 45}


class ASand(InAFolder):
    """Undrained tests 1 and 2, drained tests 3 and 4."""

    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.sand = Path(made.name) / "sand.db"
        for programme in ("icu_dense.toml", "control_drained_loose.toml"):
            for void_ratio in (0.95, 1.0):
                triax.simulate(PROGRAMMES / programme, cls.sand,
                               sets=SAND | {"specimen.void_ratio": void_ratio, "stages.4.end.1.above": 25})

    def refuses(self, call, *arguments):
        with self.subTest(arguments=arguments), self.assertRaises(triax.BadInput) as raised:
            call()
        self.assertEqual((2, str(raised.exception)), refusal(*arguments))


class Soils(ASand):
    def test_a_soil_is_that_of_the_program(self):
        for mine, options in (({}, ()), ({"tests": [1, 2, 3]}, (1, 2, 3)),
                              ({"where": "test_id > 1", "keep_odd": True}, ("--where", "test_id > 1", "--keep-odd")),
                              ({"criterion": "strain", "failure_strain": 0.05}, ("--criterion", "strain", "--failure-strain", 5)),
                              ({"criterion": "peak-ratio", "exponent": 0.6, "stress_error_kPa": 2},
                               ("--criterion", "peak-ratio", "--exponent", 0.6, "--stress-error", 2))):
            with self.subTest(options=options):
                theirs = triax_json("soil", *options, "--db", self.sand, "--json")
                self.assertEqual(triax.soil(self.sand, **mine).report, theirs)

    def test_groups_are_those_of_the_program(self):
        tests = triax_json("soil", "--db", self.sand, "--json", "--group", "material")
        self.assertEqual([s.report for s in triax.soils("material", self.sand).values()], [tests])

    def test_tables_have_the_values_of_the_document(self):
        soil = triax.soil(self.sand)
        self.assertEqual(soil.names, [t["name"] for t in soil.report["tests"]])
        for name, key in (("id", "id"), ("void_ratio", "void_ratio"), ("p_eff_kPa", "p_eff_kPa"), ("peak_q_kPa", "peak_q_kPa"),
                          ("brittleness", "brittleness"), ("strength_ratio", "strength_ratio")):
            said = [np.nan if t.get(key) is None else t[key] for t in soil.report["tests"]]
            np.testing.assert_array_equal(soil.tests[name], said, err_msg=name)
        for name in ("state_parameter", "onset_stress_ratio", "peak_stress_ratio"):
            said = [t[name]["value"] if t[name] else np.nan for t in soil.report["tests"]]
            np.testing.assert_array_equal(soil.tests[name], said, err_msg=name)
        rested = [t for t in soil.report["tests"] if t["critical"] != "none"]
        self.assertGreater(len(rested), 2)
        states = soil.critical_states
        self.assertEqual(states.test.tolist(), [t["id"] for t in rested])
        self.assertEqual(states.reached.tolist(), [t["critical"] == "reached" for t in rested])
        for name in ("stress_ratio", "p_eff_kPa", "void_ratio"):
            self.assertEqual(states[name].tolist(), [t[f"critical_{name}"]["value"] for t in rested])
        self.assertEqual(states.q_kPa.tolist(), [t["critical_q_kPa"] for t in rested])
        circles = soil.report["strength"]["circles"]
        self.assertEqual(soil.circles.major_kPa.tolist(), [c["major_kPa"] for c in circles])
        self.assertEqual([soil.names[i - 1] for i in soil.circles.test], [c["name"] for c in circles])

    def test_the_line_is_that_from_which_states_count(self):
        soil = triax.soil(self.sand)
        line = soil.critical_line(soil.tests.p_eff_kPa)
        np.testing.assert_array_equal(soil.tests.void_ratio - line.void_ratio, soil.tests.state_parameter)
        self.assertTrue((line.low < line.void_ratio).all() and (line.void_ratio < line.high).all())
        with self.assertRaisesRegex(triax.BadInput, "p_kPa 0: out of range; expected a number from 0.001 to 1e.06"):
            soil.critical_line([0])

    def test_paths_come_to_the_peak_of_the_test(self):
        soil = triax.soil(self.sand)
        for path, peak in zip(soil.paths, soil.tests.peak_q_kPa):
            self.assertEqual(path.q_kPa.max(), peak)

    def test_the_file_is_that_of_the_program(self):
        triax_json("soil", "--db", self.sand, "--json", "--output", self.folder / "theirs")
        soil = triax.soil(self.sand)
        soil.write(self.folder / "soil.toml")
        self.assertEqual((self.folder / "soil.toml").read_text(), (self.folder / "theirs/soil.toml").read_text())
        self.assertEqual(soil.toml, (self.folder / "soil.toml").read_text())

    def test_refusals_have_the_words_of_the_program(self):
        missing = self.folder / "missing.db"
        self.refuses(lambda: triax.soil(missing), "soil", "--db", missing)
        self.refuses(lambda: triax.soil(self.sand, tests=["nobody"]), "soil", "nobody", "--db", self.sand)
        self.refuses(lambda: triax.soil(self.sand, tests=[1, 2]), "soil", 1, 2, "--db", self.sand)
        self.refuses(lambda: triax.soil(self.sand, where="colour = 1"), "soil", "--where", "colour = 1", "--db", self.sand)
        self.refuses(lambda: triax.soil(self.sand, where="eta > 9"), "soil", "--where", "eta > 9", "--db", self.sand)
        for wrong, words in (({"criterion": "first"}, "criterion 'first' is not valid; must be one of: peak-q, peak-ratio, strain, critical-state"),
                             ({"failure_strain": 5}, "failure_strain 5: out of range; expected a number from 0.001 to 0.5"),
                             ({"exponent": np.nan}, "exponent nan: out of range"), ({"stress_error_kPa": -1}, "stress_error_kPa -1: out")):
            with self.assertRaisesRegex(triax.BadInput, words):
                triax.soil(self.sand, **wrong)
        with self.assertRaisesRegex(triax.BadInput, "missing group"):
            triax.soils("", self.sand)


class Calibrations(ASand):
    KEYS = ["critical_stress_ratio", "critical_void_ratio"]

    def test_a_calibration_is_that_of_the_program(self):
        mine = triax.calibrate(self.sand, "sanisand", tests=[1, 2, 3], free=self.KEYS, fix={"poisson_ratio": 0.06, "critical_slope": None},
                               searches=1, seed=4, void_ratio_error=0.004)
        theirs = triax_json("calibrate", "sanisand", 1, 2, 3, "--db", self.sand, "--free", ",".join(self.KEYS), "--fix",
                            "poisson_ratio=0.06,critical_slope", "--searches", 1, "--seed", 4, "--void-ratio-error", 0.004,
                            "--output", self.folder / "my_sand.toml", "--json")
        self.assertEqual(mine.report, theirs)
        self.assertEqual((mine.law, mine.cost, mine.start_cost), ("sanisand", theirs["cost"], theirs["start_cost"]))
        self.assertEqual((mine.names, mine.undetermined, mine.interrupted), (self.KEYS, [], False))
        for name in mine.parameters:
            self.assertEqual(mine.parameters[name].tolist(), [p[name] for p in theirs["parameters"]], name)
        self.assertEqual(mine.correlation.tolist(), theirs["correlation"])
        self.assertEqual(mine.optima.cost[0], theirs["optima"][0]["cost"])
        self.assertEqual({k: mine.optima[k][0] for k in mine.names}, theirs["optima"][0]["values"])
        self.assertEqual(mine.tests, [t["name"] for t in theirs["tests"]])
        self.assertEqual(mine.predictions.predicted.tolist(), [p["predicted"] for p in theirs["predictions"]])
        self.assertEqual(mine.predictions.test.tolist(), [1, 2])
        for curve, test in zip(mine.curves, theirs["tests"]):
            self.assertEqual(curve.rows, test["knots"])
            self.assertLess(np.abs(curve.q_kPa - curve.computed_q_kPa).max(), 0.2 * curve.q_kPa.max())
        program = (self.folder / "my_sand.toml").read_text()
        mine.write(self.folder / "my_sand.toml")
        self.assertEqual((self.folder / "my_sand.toml").read_text(), program)
        with self.assertRaises(ValueError):
            mine.correlation[0, 0] = 0

    def test_the_set_goes_into_the_other_calls(self):
        found = triax.calibrate(self.sand, "sanisand", tests=[1, 2, 3], free=self.KEYS, searches=1)
        file = self.folder / "my sand.toml"
        found.write(file)
        read = triax.Material("sanisand/my-sand", file=file)
        self.assertEqual(read.parameters, found.material.parameters)
        for name, value in zip(found.names, found.parameters.value):
            self.assertEqual(found.material.parameters[name], value)
        states = [triax.probe(m, p_kPa=100, eta=[0.6], void_ratio=0.95).states[0].least for m in (found.material, read)]
        self.assertEqual(states[0], states[1])
        sets = {"material_file": str(file), "material": "sanisand/my-sand"}
        path = self.folder / "path.toml"
        path.write_text((SAMPLES / "paths/icu_100.toml").read_text().replace(
            'material = "inl2/S28-general"', 'material = "sanisand/my-sand"\nmaterial_file = "my sand.toml"'))
        runs = triax.element(path), triax.element(SAMPLES / "paths/icu_100.toml", material=found.material)
        for name in runs[0].rows:
            np.testing.assert_array_equal(runs[0].rows[name], runs[1].rows[name], err_msg=name)
        self.assertTrue(runs[0].completed)
        points = triax.Points(found.material, [[100, 100]], 1)
        self.assertEqual(points.material.parameters, read.parameters)
        test = triax.simulate(PROGRAMMES / "icu_dense.toml", self.db,
                              sets={"specimen." + key: value for key, value in sets.items()} | {"specimen.void_ratio": 0.95})
        self.assertEqual(test.status, "complete")

    def test_it_starts_from_what_soil_wrote(self):
        triax.soil(self.sand).write(self.folder / "soil.toml")
        arguments = ("calibrate", "sanisand", 1, 2, 3, "--db", self.sand, "--free", "critical_stress_ratio", "--searches", 1,
                     "--start", self.folder / "soil.toml", "--json")
        mine = triax.calibrate(self.sand, "sanisand", tests=[1, 2, 3], free=["critical_stress_ratio"], searches=1,
                               start=self.folder / "soil.toml")
        self.assertEqual(mine.report, triax_json(*arguments))
        self.assertTrue(mine.report["notes"])

    def test_refusals_have_the_words_of_the_program(self):
        for law, more, options in (("sand", {}, ()), ("elastic", {}, ()), ("sanisand", {"tests": ["nobody"]}, ("nobody",)),
                                   ("sanisand", {"tests": [1]}, (1,)), ("sanisand", {"free": ["colour"]}, ("--free", "colour")),
                                   ("sanisand", {"fix": {"colour": None}}, ("--fix", "colour")),
                                   ("sanisand", {"fix": {"colour": 1}}, ("--fix", "colour=1")),
                                   ("sanisand", {"start": "inl2/S28-general"}, ("--start", "inl2/S28-general")),
                                   ("sanisand", {"start": "none.toml"}, ("--start", "none.toml"))):
            self.refuses(lambda: triax.calibrate(self.sand, law, **more), "calibrate", law, *options, "--db", self.sand)
        missing = self.folder / "missing.db"
        self.refuses(lambda: triax.calibrate(missing, "sanisand"), "calibrate", "sanisand", "--db", missing)
        for wrong, words in (({"searches": 0}, "searches 0: out of range; expected a number from 1 to 10000"),
                             ({"void_ratio_error": 1}, "void_ratio_error 1: out of range; expected a number from 0 to 0.5"),
                             ({"threads": -1}, "threads -1: out of range; expected a number from 0 to 4096")):
            with self.assertRaisesRegex(triax.BadInput, words):
                triax.calibrate(self.sand, "sanisand", **wrong)

    def test_progress_is_told_and_ends_it_by_false(self):
        told = []
        kept = triax.calibrate(self.sand, "sanisand", free=self.KEYS, searches=1, progress=lambda what, share: told.append((what, share)))
        self.assertFalse(kept.interrupted)
        self.assertEqual({what for what, _ in told}, {"calibrating", "cones and domain"})
        shares = [share for _, share in told]
        self.assertEqual(shares, sorted(shares))
        self.assertGreater(len(shares), 10)
        early = triax.calibrate(self.sand, "sanisand", free=self.KEYS, searches=1, progress=lambda what, share: share < 0.1)
        self.assertTrue(early.interrupted)
        self.assertGreaterEqual(early.cost, kept.cost)
        self.assertTrue(early.report["interrupted"])
        self.assertIsNone(early.report["domain"])
        self.assertEqual(kept.report["domain"]["draws"], 200)

    def test_what_progress_raises_comes_out_with_the_best_so_far(self):
        def fail(what, share):
            if share > 0.1:
                raise KeyError("enough")
        with self.assertRaises(KeyError) as raised:
            triax.calibrate(self.sand, "sanisand", free=self.KEYS, searches=1, progress=fail)
        self.assertTrue(raised.exception.best.interrupted)
        with self.assertRaises(TypeError):
            triax.calibrate(self.sand, "sanisand", free=self.KEYS, searches=1, progress=lambda: None)

    def test_ctrl_c_ends_it_with_the_best_so_far(self):
        timer = threading.Timer(1, lambda: signal.raise_signal(signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt) as raised:
            triax.calibrate(self.sand, "sanisand", searches=10000, threads=1)
        timer.join()
        self.assertTrue(raised.exception.best.interrupted)
        self.assertEqual(len(raised.exception.best.names), len(raised.exception.best.parameters.value))


if __name__ == "__main__":
    unittest.main()
