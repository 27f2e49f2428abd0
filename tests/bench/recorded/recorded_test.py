# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/recorded: scores three simulated records with a labels file of their own, and one that is missing."""
import csv
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "bench/recorded"))
import fit_cyclic  # noqa: E402
import records  # noqa: E402
import virtual_cycles  # noqa: E402

TRIAX = os.environ.get("TRIAX", str(ROOT / "build/release/triax"))
FIELDS = "time_s,axial_strain,deviator_stress_kPa,mean_effective_stress_kPa,pore_pressure_kPa"
HEAD = "file,type,kind,onset_authors,onset_peak_q,onset_r_u,rows_per_cycle,fit,columns,replay,source,licence\n"
CYCLE = 80


def simulate(programme: pathlib.Path, record: pathlib.Path) -> int | None:
    """Writes the shear stages of a simulated test, and returns the row of the onset."""
    database = str(record.with_suffix(".sqlite"))
    done = subprocess.run([TRIAX, "simulate", programme, "--db", database, "--json"], capture_output=True, text=True)
    report = json.loads(done.stdout)
    sql = ("SELECT reading, time_s, axial_strain, q_kPa, p_eff_kPa, pore_pressure_kPa FROM states "
           "WHERE stage >= (SELECT min(number) FROM stages WHERE role = 'shear') ORDER BY reading")
    done = subprocess.run([TRIAX, "query", sql, "--db", database, "--format", "csv"], capture_output=True, text=True)
    rows = list(csv.reader(io.StringIO(done.stdout)))[1:]
    record.write_text("".join([FIELDS + "\n", *(",".join(row[1:]) + "\n" for row in rows)]))
    onset = report["collapse"]["reading"]
    return None if onset is None else onset - int(rows[0][0])


class Scores(unittest.TestCase):
    def test_simulated_records(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            cyclic = folder / "programme.toml"
            cyclic.write_text(virtual_cycles.programme("cyclic", 1, "sanisand/S28-general", 1.05, CYCLE, [(20, 12, 40)]))
            samples = ROOT / "samples/programmes"
            flow = simulate(samples / "icu_42.toml", folder / "flow.csv")
            simulate(samples / "icu_dense.toml", folder / "dense.csv")
            failure = simulate(cyclic, folder / "cyclic.csv")
            labels = folder / "labels.csv"
            labels.write_text(
                "# of this test\n" + HEAD
                + f"flow.csv,undrained,flow,,{flow},,,no,3:4:2*100,,simulated,\n"
                + "dense.csv,undrained,none,,,,,no,3:4:2*100,,simulated,\n"
                + f"cyclic.csv,cyclic,flow,{failure},,,{CYCLE},no,3:4:2*100,,simulated,\n"
                + "absent.csv,cyclic,flow,100,,,80,no,3:4:2*100,,simulated,\n")
            done = subprocess.run([ROOT / "bench/recorded/run.sh", "--records", folder, "--labels", labels, "--list"],
                                  capture_output=True, text=True, env={**os.environ, "TRIAX_BUILT": "1", "TRIAX": TRIAX})
            text = " ".join(done.stdout.split())
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("3 records, 1 missing, 0 not read by triax", text)
            self.assertIn("missing: absent.csv", text)
            self.assertRegex(text, r"triax 2 of 2 1 of 1 largest q")
            self.assertRegex(text, r"triax (0\.[5-9]|1\.0)\d+ \d\.\d+ 1 of 1 [01] ")
            self.assertNotIn("published network", text)  # its figure is for other records

    def test_score_of_a_warning(self):
        test = {"onset": 400, "rows_per_cycle": 80}
        score = records.WarningScore()
        score.add(test, [i >= 320 for i in range(420)])
        self.assertEqual((score.f1, score.standing, score.withdrawn, score.leads), (1, 1, 0, [81 / 80]))
        flickering = records.WarningScore()
        flickering.add(test, [100 <= i < 110 or i >= 390 for i in range(420)])
        self.assertEqual((flickering.withdrawn, flickering.early), (1, 10))
        self.assertLess(flickering.f1, 0.3)

    def test_logistic_fit(self):
        true = [0.5, 2.0]
        windows = [([x / 10], k + 0.5 < 100 * fit_cyclic.probability(true, [x / 10])) for x in range(-20, 21) for k in range(100)]
        for found, expected in zip(fit_cyclic.fit(windows), true):
            self.assertAlmostEqual(found, expected, delta=0.03)


if __name__ == "__main__":
    unittest.main()
