#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every example of samples/python runs in an empty folder and prints what tests/python/golden has; REFRESH=1 writes that anew."""
import os
import subprocess
import sys
import unittest

import matplotlib.image
import triax
from program import ROOT, SAMPLES, InAFolder

GOLDEN = ROOT / "tests/python/golden"
EXAMPLES = sorted((SAMPLES / "python").glob("*.py"))


class Examples(InAFolder):
    def run_example(self, script):
        found = os.path.dirname(os.path.dirname(os.path.abspath(triax.__file__)))
        ended = subprocess.run([sys.executable, script], cwd=self.folder, capture_output=True, text=True,
                               env=os.environ | {"PYTHONPATH": found})
        self.assertEqual((ended.returncode, ended.stderr), (0, ""), script.name)
        return ended.stdout

    def test_there_are_twelve_each_with_its_output(self):
        self.assertEqual(len(EXAMPLES), 12)
        self.assertEqual({s.stem for s in EXAMPLES}, {g.stem for g in GOLDEN.glob("*.txt")})

    def test_the_figures_show_something(self):
        for name in ("figures", "soil"):
            self.run_example(SAMPLES / f"python/{name}.py")
            pixels = matplotlib.image.imread(self.folder / f"{name}.png")
            self.assertEqual(pixels.shape[:2], (630, 1500))
            coloured = (pixels[..., :3].max(axis=2) - pixels[..., :3].min(axis=2)) > 0.3
            for half in (coloured[:, :750], coloured[:, 750:]):
                self.assertGreater(half.sum(), 1000, name)
        self.assertIn("<svg", (self.folder / "figures.svg").read_text())


def prints_what_is_golden(script):
    def test(self):
        printed, golden = self.run_example(script), GOLDEN / f"{script.stem}.txt"
        if os.environ.get("REFRESH"):
            golden.write_text(printed)
        self.assertEqual(printed, golden.read_text())
    return test


for one in EXAMPLES:
    setattr(Examples, f"test_{one.stem}", prints_what_is_golden(one))

if __name__ == "__main__":
    unittest.main()
