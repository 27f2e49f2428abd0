# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/assessment: programmes are drawn within their ranges, exports lose what they should, and the table counts what it says."""
import lzma
import pathlib
import random
import subprocess
import sys
import tempfile
import tomllib
import unittest

sys.dont_write_bytecode = True
ASSESSMENT = pathlib.Path(__file__).resolve().parents[2] / "bench/assessment"
sys.path.insert(0, str(ASSESSMENT))
import compare  # noqa: E402
import export_forms  # noqa: E402
import make_programmes  # noqa: E402
import tables  # noqa: E402
from programmes import soils  # noqa: E402


def programme(number, seed=3):
    row, parts, listed, material = make_programmes.draw_programme(seed, number)
    return row, tomllib.loads(make_programmes.text_of(parts, listed, "test")), tomllib.loads(material)


class Programmes(unittest.TestCase):
    def test_are_reproducible(self):
        def files(*arguments):
            with tempfile.TemporaryDirectory() as name:
                subprocess.run([sys.executable, ASSESSMENT / "make_programmes.py", "--seed", "5", "--out", name, *arguments], check=True)
                return {p.name: p.read_text(encoding="utf-8") for p in pathlib.Path(name).iterdir()}
        few, more = files("--count", "3"), files("--count", "5")
        self.assertEqual(len(few), 3 * 3 + 1)
        self.assertEqual({n: more[n] for n in few if n != "index.csv"}, {n: t for n, t in few.items() if n != "index.csv"})
        self.assertEqual(files("--only", "3")["5_0003.toml"], few["5_0003.toml"])
        self.assertNotEqual(few["5_0001.toml"].split("[test]")[1], few["5_0002.toml"].split("[test]")[1])

    def test_cover_the_space(self):
        rows = [programme(i)[0] for i in range(1, 301)]
        self.assertEqual({r["control"] for r in rows}, set(make_programmes.CONTROLS))
        self.assertEqual({r["law"] for r in rows}, set(soils.LAWS))
        self.assertLess(min(r["p0_kPa"] for r in rows), 25)
        self.assertGreater(max(r["p0_kPa"] for r in rows), 1200)
        features = " ".join(r["features"] for r in rows)
        for feature in ("rest", "loop", "rate change", "bias", "no B check", "B check after consolidation", "consolidated in steps"):
            self.assertIn(feature, features)
        for key in ("extension", "membrane", "consolidation_ratio"):
            self.assertTrue(5 < sum(r[key] != 0 for r in rows) < 150, key)

    def test_change_parameters_by_a_tenth(self):
        for number in range(1, 60):
            row, document, material = programme(number)
            name, drawn = row["set"], material["sets"]["drawn"]
            original = soils.sets_of(row["law"])[name]
            self.assertEqual(document["specimen"]["material"], f"{row['law']}/drawn")
            for key, value in original.items():
                if isinstance(value, float) and key != "overconsolidation_ratio":
                    self.assertLessEqual(abs(drawn[key] - value), 0.1001 * abs(value), (row["law"], key))

    def test_have_ideal_instruments_beside(self):
        _, parts, listed, _ = make_programmes.draw_programme(3, 7)
        ideal, stages = make_programmes.ideal(parts, listed)
        self.assertFalse([k for k in ideal if "transducers" in k or "controller" in k])
        self.assertEqual(ideal["specimen"], parts["specimen"])
        self.assertEqual([s["name"] for s in stages], [s["name"] for s in listed])


class FakeTest:
    """90 readings of shear after 10 of consolidation, lost at 60 s of shear."""
    size = {"height_mm": 140.0, "diameter_mm": 70.0}
    stages = {1: {"role": "consolidation", "drainage": "open"}, 2: {"role": "shear", "drainage": "closed"}}
    loss_s = 70.4

    def __init__(self):
        self.rows = []
        for i in range(100):
            q = max(0.0, i - 10.0) if i < 70 else max(0.0, 60 - 3.0 * (i - 70))
            self.rows.append({"reading": i, "time_s": i + 0.4, "stage": 1 if i < 10 else 2, "axial_displacement_mm": 0.1 * i,
                              "axial_force_kN": q * 3.8e-3, "cell_pressure_kPa": 400 + 0.1 * (i % 3), "back_pressure_kPa": 300.0,
                              "pore_pressure_kPa": 300 + 0.5 * i, "back_volume_mm3": 1.0, "axial_strain": 1e-3 * i, "volumetric_strain": 0.0,
                              "q_kPa": q})

    is_shear, shear, drained = export_forms.StoredTest.is_shear, export_forms.StoredTest.shear, export_forms.StoredTest.drained


def table_of(text):
    lines = text.split("\n")
    return lines[3].split(","), [line.split(",") for line in lines[4:-1]]


class Forms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.test = FakeTest()
        cls.forms = {form: (*table_of(text), readings) for form, text, readings in export_forms.forms(cls.test, "1/1")}

    def test_all_are_made(self):
        self.assertEqual(list(self.forms), ["raw", "minute", "held", "reduced", "thinned", *export_forms.CUTS])
        for form, (head, rows, readings) in self.forms.items():
            self.assertEqual(len(rows), len(readings), form)
            self.assertFalse([h for h in head if "tage" in h or "ontrol" in h], form)

    def test_clocks_are_rounded(self):
        self.assertEqual([row[0] for row in self.forms["raw"][1][:3]], ["0", "1", "2"])
        self.assertEqual({row[0] for row in self.forms["minute"][1]}, {"0", "1", "2"})

    def test_held_pressures_have_no_noise(self):
        head, rows, _ = self.forms["held"]
        self.assertEqual({row[head.index("Cell pressure (kPa)")] for row in rows}, {"400.00"})
        self.assertGreater(len({row[head.index("Cell pressure (kPa)")] for row in self.forms["raw"][1]}), 1)

    def test_reduced_is_of_shear(self):
        head, rows, readings = self.forms["reduced"]
        self.assertEqual(readings, list(range(10, 100)))
        self.assertNotIn("Volumetric strain (%)", head)
        self.assertAlmostEqual(float(rows[-1][head.index("Axial strain (%)")]), 9.9)

    def test_thinned_keeps_20_to_300_rows(self):
        rows = [dict(self.test.rows[i % 90 + 10], reading=i) for i in range(3000)]
        for seed in range(20):
            count = len(export_forms.thinned(random.Random(seed), rows))
            self.assertTrue(20 <= count <= 300, count)

    def test_cuts_end_where_they_say(self):
        loss = 70
        self.assertLess(self.forms["ends before"][2][-1], loss)
        self.assertEqual(self.forms["ends at"][2][-1], loss)
        after = self.forms["ends after"][2]
        self.assertTrue(loss < after[-1] < loss + 12, after[-1])
        self.assertGreater(len(self.forms["ends long after"][2]), 100)


def row(**changes):
    return {"truth_lost": "1", "truth_eta": "0.6", "truth_slip": "", "truth_q_lost": "0.8", "least_p": "0.3", "ideal_lost": "", "ideal_eta": "",
            "limit_eta": "1.2", "verdict": "collapse", "kind": "flow", "eta": "0.61", "eta_low": "0.59", "eta_high": "0.63", "imminent": "",
            "fall_reading": "", "standing": "", "form": "simulated", "outcome": "ok"} | changes


class Table(unittest.TestCase):
    def test_bounds_are_exact(self):
        # Clopper and Pearson (1934), as tabulated: 5 of 10, 0 of 10, 73 of 100
        for hits, count, low, high in ((5, 10, 0.1871, 0.8129), (0, 10, 0.0, 0.3085), (10, 10, 0.6915, 1.0), (73, 100, 0.6320, 0.8139)):
            found = tables.exact_bounds(hits, count)
            self.assertAlmostEqual(found[0], low, 3)
            self.assertAlmostEqual(found[1], high, 3)

    def test_truth_has_a_class(self):
        self.assertEqual(tables.truth(row()), "lost")
        self.assertEqual(tables.truth(row(truth_lost="0", truth_eta="")), "not lost")
        self.assertEqual(tables.truth(row(truth_lost="0")), "not lost")  # the form ends before
        for changes, name in (({"truth_lost": ""}, "ends at the loss"), ({"truth_slip": "1"}, "slip"), ({"truth_q_lost": "0.05"}, "small loss"),
                              ({"truth_eta": "1.15"}, "at the limit"), ({"truth_eta": "-0.85"}, "at the limit"),
                              ({"truth_lost": "0", "truth_eta": "", "least_p": "0.01"}, "liquefied"),
                              ({"truth_lost": "0", "ideal_lost": "1", "ideal_eta": "0.5"}, "servo"), ({"ideal_lost": "0"}, "servo"), ({"ideal_lost": "1", "ideal_eta": "0.5"}, "servo")):
            self.assertEqual(tables.truth(row(**changes)), name, changes)
            self.assertIn(name, tables.UNCOUNTED)

    def test_counts(self):
        self.assertTrue(tables.missed(row(verdict="none")))
        self.assertFalse(tables.missed(row(verdict="indeterminate")))
        stable = {"truth_lost": "0", "truth_eta": ""}
        self.assertTrue(tables.false_collapse(row(**stable)))
        self.assertFalse(tables.false_collapse(row(**stable, kind="cyclic_mobility")))
        self.assertTrue(tables.covered(row()))
        self.assertFalse(tables.covered(row(truth_eta="0.64")))
        fall = row(fall_reading="100", imminent="90")
        self.assertTrue(tables.fell(fall) and tables.warned(fall))
        self.assertFalse(tables.warned(row(fall_reading="100", imminent="100")))
        self.assertTrue(tables.false_alarm(row(**stable, imminent="5")))
        self.assertTrue(tables.stands(row(verdict="none", standing="imminent")))


class Comparison(unittest.TestCase):
    def test_finds_what_changed(self):
        old = {("1", "simulated"): {"number": "1", "form": "simulated", "outcome": "ok", "eta": "0.5", "kind": "flow"},
               ("2", "simulated"): {"number": "2", "form": "simulated", "outcome": "ok", "eta": "0.7", "kind": "none"}}
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "expected.csv.xz"
            compare.store(path, old)
            self.assertIn(b"simulated", lzma.decompress(path.read_bytes()))
            self.assertEqual(compare.read(path), old)
        self.assertEqual(compare.merged(old, {("1", "raw"): {"number": "1"}}), {("1", "raw"): {"number": "1"}, ("2", "simulated"): old["2", "simulated"]})
        new = {("1", "simulated"): old["1", "simulated"] | {"eta": "0.50001"}}
        self.assertEqual(compare.differences(new, old), [])  # the other was not run
        new["1", "simulated"]["kind"] = "partial"
        self.assertEqual(compare.differences(new, old), ["1, simulated: kind flow -> partial"])
        new["1", "raw"] = new["1", "simulated"]
        self.assertEqual(len(compare.differences(new, old)), 2)


if __name__ == "__main__":
    unittest.main()
