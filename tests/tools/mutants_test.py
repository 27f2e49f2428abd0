# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/mutants: finds the places that can be changed, leaves everything else alone, and reports what no test noticed."""
import contextlib
import importlib.machinery
import importlib.util
import io
import pathlib
import random
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
PATH = pathlib.Path(__file__).resolve().parents[2] / "tools/mutants"
LOADER = importlib.machinery.SourceFileLoader("mutants", str(PATH))
mutants = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutants", LOADER))
sys.modules["mutants"] = mutants
LOADER.exec_module(mutants)

SOURCE = """// a < 2 && b
#include "x2.hpp"
namespace triax {
static_assert(4 < 5, "4");
constexpr double kLimit = 2.5;
std::vector<std::pair<int, int>> kEmpty;
void report(const State& s, int) {
  if (s.q < kLimit && s.p >= 4) count("more than 3");
  for (const auto& one : s.all) use(one);
}
Watch::Watch(int a) : a_(a) { begin(); }
bool Watch::is_lost() const {
  const auto twice = [](double x) { return x * 2; };
  if (a_ == 0) {
    return true;
  } else {
    return twice(a_) > 1e3;
  }
}
int number() { return 0; }
}
"""


class Changes(unittest.TestCase):
    def setUp(self):
        self.changes = mutants.changes_of(SOURCE)

    def of(self, kind):
        return [(SOURCE[c.begin:c.end], c.text) for c in self.changes if c.kind == kind]

    def test_bodies_are_emptied(self):
        self.assertEqual([new for _, new in self.of("body")], ["{}", "{}", "{ return {}; }", "{ return {}; }"])
        self.assertTrue(self.of("body")[0][0].startswith("{\n  if (s.q"))

    def test_comparisons_are_turned(self):
        self.assertEqual(self.of("comparison"), [("<", ">="), (">=", "<"), ("==", "!="), (">", "<=")])

    def test_numbers_are_doubled_and_halved(self):
        self.assertEqual(self.of("number"), [("2.5", "5.0"), ("2.5", "1.25"), ("4", "8"), ("4", "2"), ("2", "4"), ("2", "1"),
                                             ("1e3", "2000.0"), ("1e3", "500.0")])

    def test_conditions_are_removed(self):
        self.assertEqual(self.of("condition"), [('if (s.q < kLimit && s.p >= 4) count("more than 3");', ";"), ("&& s.p >= 4", "")])

    def test_a_change_changes_one_place(self):
        for change in self.changes:
            changed = change.apply(SOURCE)
            self.assertNotEqual(changed, SOURCE)
            self.assertEqual(changed[:change.begin], SOURCE[:change.begin])
            self.assertTrue(changed.endswith(SOURCE[change.end:]))
            self.assertIn(f"x.cpp:{SOURCE.count(chr(10), 0, change.begin) + 1}: {change.kind}: ", mutants.described("x.cpp", SOURCE, change))

    def test_draws_every_kind(self):
        listed = [("x.cpp", SOURCE, c) for c in self.changes]
        drawn = mutants.drawn(random.Random(1), listed, 4)
        self.assertEqual({c.kind for _, _, c in drawn[:4]}, {"body", "comparison", "number", "condition"})
        self.assertEqual(len(drawn), len(listed))


class FakeTrial(mutants.Trial):
    """Builds what has no 5.0, and notices every change but those of conditions."""
    def __init__(self, folder):
        self.build, self.test, self.folder = ["build"], ["test"], folder

    def run(self, command):
        text = (self.folder / "x.cpp").read_text(encoding="utf-8")
        return "5.0" not in text if command == ["build"] else "s.p >= 4" not in text


class Survivors(unittest.TestCase):
    def test_are_reported_and_the_source_is_restored(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "x.cpp").write_text(SOURCE, encoding="utf-8")
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                survivors = mutants.try_changes(FakeTrial(folder), [(folder / "x.cpp", SOURCE, c) for c in mutants.changes_of(SOURCE)], 0)
            self.assertEqual((folder / "x.cpp").read_text(encoding="utf-8"), SOURCE)
        self.assertEqual(len([s for s in survivors if "condition: " in s]), 2)
        self.assertIn("does not compile", printed.getvalue())
        self.assertIn(f"{len(mutants.changes_of(SOURCE)) - 1} changes, {len(survivors)} survived", printed.getvalue())


if __name__ == "__main__":
    unittest.main()
