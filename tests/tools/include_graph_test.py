# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/include-graph on small trees: a clean one passes, and each rule fails on what was planted against it."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "tools" / "include-graph"

CLEAN = {
    "sim/law/law.hpp": "#pragma once\n",
    "sim/law/law.cpp": '#include "sim/law/law.hpp"\n',
    "lab/base/text.hpp": '#include "sim/law/law.hpp"\n#include <vector>\n',
    "db/store.hpp": '#include "lab/base/text.hpp"\n',
    "src/study/run.hpp": '#include "db/store.hpp"\n',
    "src/cli/command.hpp": '#include "src/study/run.hpp"\n',
}


class IncludeGraph(unittest.TestCase):
    def check(self, planted, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**CLEAN, **planted}.items():
                path = Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return subprocess.run([sys.executable, SCRIPT, "--root", folder, *arguments], capture_output=True, text=True,
                                  check=False)

    def fails(self, planted, *words):
        done = self.check(planted)
        self.assertEqual(done.returncode, 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_a_clean_tree_passes(self):
        done = self.check({})
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_circle_of_folders(self):
        self.fails({"sim/point/step.hpp": '#include "sim/law/law.hpp"\n',
                    "sim/law/other.cpp": '#include "sim/point/step.hpp"\n'},
                   "circle of folders: sim/law, sim/point", "sim/law/other.cpp:1 -> sim/point/step.hpp")

    def test_a_circle_of_folders_over_three(self):
        self.fails({"lab/a/a.hpp": '#include "lab/b/b.hpp"\n', "lab/b/b.hpp": '#include "lab/c/c.hpp"\n',
                    "lab/c/c.cpp": '#include "lab/a/a.hpp"\n', "lab/c/c.hpp": ""},
                   "circle of folders: lab/a, lab/b, lab/c")

    def test_a_circle_of_files(self):
        self.fails({"sim/law/one.hpp": '#include "sim/law/two.hpp"\n', "sim/law/two.hpp": '#include "sim/law/one.hpp"\n'},
                   "circle of files: sim/law/one.hpp, sim/law/two.hpp")
        self.fails({"sim/law/self.hpp": '#include "sim/law/self.hpp"\n'}, "circle of files: sim/law/self.hpp")

    def test_header_and_source_of_one_pair_may(self):
        done = self.check({"sim/law/kernel.hpp": '#include "sim/law/kernel.cpp"\n',
                           "sim/law/kernel.cpp": '#include "sim/law/kernel.hpp"\n'})
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_arrows_upwards(self):
        self.fails({"sim/law/high.cpp": '#include "lab/base/text.hpp"\n'},
                   "sim/law/high.cpp:1: arrow upwards: sim includes lab/base/text.hpp")
        self.fails({"lab/base/high.cpp": '\n  #  include "db/store.hpp"\n'}, "lab/base/high.cpp:2: arrow upwards")
        self.fails({"src/study/high.cpp": '#include "src/cli/command.hpp"\n'}, "arrow upwards: src/study includes src/cli")
        self.fails({"db/high.cpp": '#include "src/study/run.hpp"\n'}, "arrow upwards: db includes src/study/run.hpp")

    def test_a_wide_folder(self):
        self.fails({f"lab/wide/w{i}.hpp": "" for i in range(46)}, "lab/wide: 46 files")
        self.assertEqual(self.check({f"lab/wide/w{i}.hpp": "" for i in range(45)}).returncode, 0)

    def test_figures(self):
        planted = {"sim/law/long.cpp": "int f(\n    int x) {\n  return x;\n}\n\nint longer() {\n\n\n\n  return 1;\n}\n"}
        lines = self.check(planted, "--figures").stdout.splitlines()
        self.assertIn(["sim/law", "3", "13"], [line.split() for line in lines])
        at = lines.index("longest functions")
        self.assertEqual([line.split() for line in lines[at + 1:at + 3]],
                         [["6", "sim/law/long.cpp:6", "longer"], ["4", "sim/law/long.cpp:1", "f"]])

    def test_a_folder_without_sources_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, SCRIPT, "--root", folder], capture_output=True, check=False)
        self.assertEqual(done.returncode, 1)


if __name__ == "__main__":
    unittest.main()
