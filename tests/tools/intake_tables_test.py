# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/intake: the tables agree with what is expected of them, and the score tells right readers from wrong ones."""
import collections
import copy
import io
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
import zipfile
from contextlib import redirect_stdout

sys.dont_write_bytecode = True
INTAKE = pathlib.Path(__file__).resolve().parents[2] / "bench/intake"
sys.path.insert(0, str(INTAKE))
import check_tables  # noqa: E402
import make_tables  # noqa: E402
import score  # noqa: E402

READER = """import pathlib, sys
path = pathlib.Path(sys.argv[1])
text = path.with_suffix(".expected.toml").read_text(encoding="utf-8")
print(text.replace('"deviator_stress"', '"half_deviator_stress"') if len(sys.argv) > 2 else text)
"""
ALSO = [{"fill": "1e30"}, {"order": "reversed"}, {"blocks": "beside"}, {"blocks": "below"}, {"blocks": "below_without_headings"},
        {"blocks": "restart"}, {"kind": "stages", "clock": "stage_only"}, {"definition": "t_s_named_q_p"}, {"language": "zh"},
        {"encoding": "utf-16"}, {"headings": "0"}, {"clock": "midnight_bare", "container": "xlsx"}, {"thousands": "comma"},
        {"separator": "wide", "fill": "blank"}, {"axial_sign": "tension_positive"}, {"clock": "month_name"}, {"clock": "mdy_ampm"}]


class Tables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.tomls = []
        for index in range(200):
            cls.write(*make_tables.make_file(1, index, {}))
        for index, forced in enumerate(ALSO):
            cls.write(*make_tables.make_file(2, index, forced))
        cls.expected = [tomllib.loads(toml.read_text(encoding="utf-8")) for toml in cls.tomls]

    @classmethod
    def write(cls, name, data, toml):
        (cls.folder / name).write_bytes(data)
        path = (cls.folder / name).with_suffix(".expected.toml")
        path.write_text(toml, encoding="utf-8")
        cls.tomls.append(path)

    def outcomes(self, change, refused=False, where=lambda e: True):
        """Outcomes of a reader whose answers are the expected ones with a change, for the files in which it made one."""
        found = collections.Counter()
        for expected in filter(where, self.expected):
            answer = copy.deepcopy(expected)
            if change(answer) is not False:
                found[score.outcome(expected, answer, refused)[0]] += 1
        self.assertTrue(found)
        return found


class Generator(Tables):
    def test_identities_hold_within_the_rounding(self):
        files = [check_tables.File(toml) for toml in self.tomls]
        self.assertEqual([fault for file in files for fault in file.faults], [])
        self.assertGreater(sum(file.identities for file in files), 100)

    def test_same_seed_gives_the_same_file(self):
        for index in (3, 7, 70):
            self.assertEqual(make_tables.make_file(5, index, {}), make_tables.make_file(5, index, {}))
        self.assertNotEqual(make_tables.make_file(5, 3, {})[1], make_tables.make_file(6, 3, {})[1])

    def test_forced_traits_are_kept(self):
        for forced in ALSO:
            traits = tomllib.loads(make_tables.make_file(3, 1, forced)[2])["traits"]
            self.assertTrue(all(traits[key] == value for key, value in forced.items() if key != "thousands"), forced)
        with self.assertRaises(ValueError):
            make_tables.make_file(1, 1, {"kind": "UC", "pore": "total"})

    def test_held_back_headings_are_published_only(self):
        def held(seed):
            return sum(tomllib.loads(make_tables.make_file(seed, i, {})[2])["traits"]["names"] == "held_back" for i in range(20))
        self.assertEqual(held(999), 0)
        self.assertGreater(held(1000), 0)

    def test_workbook_has_a_sheet_of_readings(self):
        books = [e for e in self.expected if e["separator"] == "sheet"]
        self.assertTrue(books)
        for e in books:
            with zipfile.ZipFile(self.folder / e["file"]) as book:
                self.assertIn(f'name="{e["sheet"]}"', book.read("xl/workbook.xml").decode())

    def test_check_finds_a_changed_file(self):
        changes = {
            "a cell": lambda data, toml: (data.replace(b"0.0", b"7.7", 12), toml),
            "a factor": lambda data, toml: (data, toml.replace("factor = 1.0\n", "factor = 1000.0\n")),
            "a sign": lambda data, toml: (data, toml.replace("sign = 1\n", "sign = -1\n")),
            "a quantity": lambda data, toml: (data, toml.replace('"deviator_stress"', '"half_deviator_stress"')),
            "a first value": lambda data, toml: (data, re.sub(r"first = (-?)(\d)", r"first = \g<1>9\2", toml)),
        }
        forced = {"container": "text", "view": "reduced", "kind": "CID", "stresses": "none", "fill": "none",
                  "clock": "elapsed_s", "units": "si", "decimal": "point", "definition": "q_p", "numbers": "plain",
                  "encoding": "utf-8", "headings": "1"}
        for name, change in changes.items():
            found = 0
            for index in range(10):
                with tempfile.TemporaryDirectory() as folder:
                    file, data, toml = make_tables.make_file(4, index, forced)
                    data, toml = change(data, toml)
                    path = pathlib.Path(folder) / file
                    path.write_bytes(data)
                    path.with_suffix(".expected.toml").write_text(toml, encoding="utf-8")
                    found += bool(check_tables.File(path.with_suffix(".expected.toml")).faults)
            self.assertGreaterEqual(found, 5, name)


def has_headings(expected):
    """Tests and the order of rows are only compared if the columns are known."""
    return "headings" not in expected["ask"]


class Score(Tables):
    def test_perfect_reader_reads_all(self):
        found = self.outcomes(lambda answer: None)
        self.assertEqual(set(found), {"right", "asked"})
        self.assertGreater(found["right"], found["asked"])

    def test_wrong_meanings_are_wrong(self):
        def first_number(answer):
            return next((c for c in answer["columns"] if c.get("factor") and c["unit"] not in ("div", "h:mm:ss")), None)

        def change(key, value):
            def apply(answer):
                column = first_number(answer)
                if not column or key == "sign" and column.get("sign_open"):
                    return False
                column[key] = value(column[key])
            return apply
        faults = {
            "factor": change("factor", lambda x: 1000 * x), "sign": change("sign", lambda x: -x),
            "quantity": change("quantity", lambda _: "cycle_"),
            "last": change("last", lambda x: x + 1), "tests": lambda answer: answer.update(tests=7),
            "order": lambda answer: answer.update(row_order="reversed" if "row_order" not in answer else "ascending"),
            "readings": lambda answer: answer["data_lines"].pop(),
            "fill values": lambda answer: answer.pop("missing", None) is not None,
            "kind": lambda answer: answer.update(kind="UC" if "cyclic" in answer["kind"] else "cyclic, undrained"),
        }
        for name, fault in faults.items():
            known = {"kind": lambda e: e["kind"] != "not said", "tests": has_headings, "order": has_headings}.get(name, lambda e: True)
            self.assertEqual(set(self.outcomes(fault, where=known)), {"wrong"}, name)

    def test_refusal_with_a_right_proposal_is_proposed(self):
        self.assertEqual(set(self.outcomes(lambda answer: None, refused=True)), {"proposed"})
        self.assertEqual(set(self.outcomes(lambda answer: answer.update(tests=7), where=has_headings, refused=True)), {"refused"})
        self.assertEqual(score.outcome(self.expected[0], None, True)[0], "refused")
        self.assertEqual(score.outcome(self.expected[0], None, False)[0], "failed")

    def test_missing_question_is_unasked(self):
        def guess(answer):
            answer["ask"] = []
            for column in answer["columns"]:
                if column.get("unit_source") == "asked":
                    scale = column.get("true_factor", 1) * column.get("true_sign", 1)
                    column.update({key: column[f"{key}_as_written"] * scale for key in ("first", "last") if f"{key}_as_written" in column})
                    column.update(unit_source="heading")
        self.assertEqual(set(self.outcomes(guess, where=lambda e: e["ask"])), {"unasked"})

    def test_needless_question(self):
        found = self.outcomes(lambda answer: answer["ask"].append("colour"), where=lambda e: "headings" not in e["ask"])
        self.assertEqual(set(found), {"needless"})

    def test_unused_column(self):
        def drop(answer):
            column = next((c for c in answer["columns"] if c["quantity"] in ("deviator_stress", "cell_pressure", "axial_force")), None)
            if column is None or answer["ask"]:
                return False
            column.update(quantity="ignored")
            answer["missing"] = [m for m in answer.get("missing", []) if m[1] != column["position"]]
        self.assertEqual(set(self.outcomes(drop)), {"unused"})

    def test_equivalent_quantities_are_right(self):
        def rename(answer):
            column = next((c for c in answer["columns"] if c["quantity"] == "back_volume" and c["unit_source"] != "asked"), None)
            if column is None:
                return False
            column.update(quantity="volume_change", sign=-column["sign"], first=-column["first"], last=-column["last"])
        self.assertLessEqual(set(self.outcomes(rename)), {"right", "asked"})

    def test_command_is_run_for_each_file(self):
        reader = self.folder / "reader.py"
        reader.write_text(READER, encoding="utf-8")
        few = self.folder / "few"
        few.mkdir(exist_ok=True)
        for index in range(6):
            name, data, toml = make_tables.make_file(9, index, {"view": "reduced", "kind": "ICU", "definition": "q_p", "headings": "1"})
            (few / name).write_bytes(data)
            (few / name).with_suffix(".expected.toml").write_text(toml, encoding="utf-8")

        def run(*command):
            return subprocess.run([sys.executable, INTAKE / "score.py", few, "--by", "kind", "--", *command], capture_output=True,
                                  text=True, check=False)
        right = run(sys.executable, str(reader))
        self.assertEqual((right.returncode, right.stderr), (0, ""))
        self.assertRegex(right.stdout, r"all +6 .* 100\.0 \[ 61\.0, 100\.0\] +0\.0 \[  0\.0,  39\.0\]")
        self.assertRegex(right.stdout, r"kind=ICU +6 ")
        wrong = run(sys.executable, str(reader), "{}", "wrong")
        self.assertEqual(wrong.returncode, 1)
        self.assertRegex(wrong.stdout, r"all +6 .* 100\.0 \[ 61\.0, 100\.0\]\n")
        crashed = run("false")
        self.assertRegex(crashed.stdout, r"all +6 +0 +0 +0 +0 +0 +0 +6 ")

    def test_wilson_interval(self):
        low, high = score.wilson(81, 263)  # Newcombe 1998, table I
        self.assertAlmostEqual(low, 0.2553, 4)
        self.assertAlmostEqual(high, 0.3662, 4)
        self.assertEqual(score.wilson(0, 20)[0], 0)
        self.assertAlmostEqual(score.wilson(0, 20)[1], 0.1611, 4)


class Commands(unittest.TestCase):
    def test_check_tables_prints_a_summary(self):
        with tempfile.TemporaryDirectory() as folder:
            for index in range(3):
                name, data, toml = make_tables.make_file(1, index, {})
                (pathlib.Path(folder) / name).write_bytes(data)
                (pathlib.Path(folder) / name).with_suffix(".expected.toml").write_text(toml, encoding="utf-8")
            text, sys.argv = io.StringIO(), ["check_tables.py", folder]
            with redirect_stdout(text):
                status = check_tables.main()
            self.assertEqual(status, 0, text.getvalue())
            self.assertRegex(text.getvalue(), r"^3 files, \d+ cells, \d+ identities, .* 0 files with faults\n$")

    def test_unknown_trait_is_named(self):
        done = subprocess.run([sys.executable, INTAKE / "make_tables.py", "--out", "/nonexistent", "--trait", "colour=red"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("unknown trait colour; must be one of: kind, direction", done.stderr)


if __name__ == "__main__":
    unittest.main()
