# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the Python module share: the program to compare with, and a folder that goes with the test."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "samples"
PROGRAM = os.environ.get("TRIAX", str(ROOT / "build/release/triax"))


def triax_json(*arguments):
    return json.loads(subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, check=True, text=True).stdout)


def refusal(*arguments):
    """(status, the line that the program ends with)"""
    ended = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    return ended.returncode, ended.stderr.removeprefix("triax: ").rstrip("\n")


class InAFolder(unittest.TestCase):
    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = Path(made.name)
        self.db = self.folder / "tests.db"
