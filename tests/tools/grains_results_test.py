#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Kept results of grains are refused where a programme or the engine has changed since (tools/grains-results)."""
import copy
import importlib.machinery
import importlib.util
import json
import pathlib
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def module():
    loader = importlib.machinery.SourceFileLoader("grains_results", str(ROOT / "tools/grains-results"))
    made = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(made)
    return made


class Quick:
    """In place of the program: what the sample `quick` comes to."""

    def __init__(self, porosity: float):
        self.document = {"programme": {"source": "here"}, "version": 1, "stages": [{"porosity": porosity}]}

    def run(self, *_arguments: str) -> str:
        return json.dumps(self.document)

    @staticmethod
    def sample(name: str) -> str:
        return name


class KeptResults(unittest.TestCase):
    def setUp(self):
        self.results = module()
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.results.KEPT = pathlib.Path(self.folder.name) / "grains.json"
        self.kept = {"quick": self.results.digits_of_quick(Quick(0.4).run()),
                     "runs": {"dense": {"programme_digest": self.results.digest_of("dense"), "stages": []}}}

    def read(self, kept: dict, quick: Quick):
        self.results.KEPT.write_text(json.dumps(kept), encoding="utf-8")
        return self.results.kept_results(quick)

    def test_what_the_program_of_today_comes_to_is_taken(self):
        self.assertEqual(self.read(self.kept, Quick(0.4)), self.kept["runs"])

    def test_another_programme_or_another_digit_of_the_engine_is_refused(self):
        other = copy.deepcopy(self.kept)
        other["runs"]["dense"]["programme_digest"] = "0"
        with self.assertRaisesRegex(SystemExit, "dense.toml has changed; run tools/grains-figures"):
            self.read(other, Quick(0.4))
        with self.assertRaisesRegex(SystemExit, "another engine"):
            self.read(self.kept, Quick(0.40000000000000002220446049250313 + 1e-16))

    def test_where_the_file_lies_does_not_matter(self):
        elsewhere = Quick(0.4)
        elsewhere.document["programme"]["source"] = "/there"
        self.assertEqual(self.read(self.kept, elsewhere), self.kept["runs"])


if __name__ == "__main__":
    unittest.main()
