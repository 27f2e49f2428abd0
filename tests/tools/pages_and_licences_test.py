# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/check-links, tools/spdx and tools/check-version on small trees: a clean one passes, what was planted is found."""
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[2] / "tools"

RECORD = "# 1. One\n\nDate: 2026-01-02\n\nStatus: accepted\n\n## Context\n\nA.\n\n## Decision\n\nB.\n\n## Consequences\n\nC.\n"
CLEAN = {
    "README.md": "# Top\n\n[page](docs/page.md#two-words) ![](docs/a.svg) [away](https://example.invalid/x) `[code](no.md)`\n\n"
                 "    [an example](nowhere.md)\n",
    "docs/page.md": "# Page\n\n## Two words\n\n[up](../README.md) [here](#page)\n",
    "docs/a.svg": "<svg/>\n",
    "docs/decisions/0001-one.md": RECORD,
    "docs/decisions/README.md": "# All\n\n1. [One](0001-one.md), 2026-01-02,\n   accepted\n",
}
VERSIONS = {
    "CMakeLists.txt": "project(triax VERSION 1.2.3 LANGUAGES CXX)\n",
    "CHANGELOG.md": "# Changes\n\n## 1.2.3 (2026-01-02)\n\n## 1.2.2 (2025-01-02)\n",
    "CITATION.cff": "version: 1.2.3\ndate-released: 2026-01-02\n",
}


class Tree(unittest.TestCase):
    def run_tool(self, tool, files, *arguments):
        """The tool in a tree of these files; its result, and the files as it left them."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            (root / "tools/remade").mkdir(parents=True)
            for name in (tool, "remade/markdown.py"):
                shutil.copy(TOOLS / name, root / "tools" / name)
            subprocess.run(["git", "init", "-q", folder], check=True)
            subprocess.run(["git", "-C", folder, "add", *files], check=True)
            done = subprocess.run([sys.executable, root / "tools" / tool, *arguments], cwd=folder, capture_output=True, text=True,
                                  check=False)
            return done, {name: (root / name).read_text(encoding="utf-8") for name in files}

    def finds(self, tool, files, *words):
        done, _ = self.run_tool(tool, files)
        self.assertEqual(done.returncode, 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)


class Links(Tree):
    def test_a_clean_tree_passes(self):
        done, _ = self.run_tool("check-links", CLEAN)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_page_that_is_missing(self):
        self.finds("check-links", {**CLEAN, "docs/page.md": "# Page\n\n## Two words\n\n[x](gone.md)\n"},
                   "docs/page.md:5: gone.md: there is no docs/gone.md")

    def test_an_anchor_that_is_missing(self):
        self.finds("check-links", {**CLEAN, "docs/page.md": "# Page\n"}, "no heading for #two-words")

    def test_a_record_of_another_form(self):
        self.finds("check-links", {**CLEAN, "docs/decisions/0001-one.md": RECORD.replace("## Context", "## Question")},
                   "not in the form")

    def test_a_record_that_the_list_tells_otherwise(self):
        self.finds("check-links", {**CLEAN, "docs/decisions/0001-one.md": RECORD.replace("2026-01-02", "2026-01-03")}, "its entry")

    def test_a_built_site(self):
        page = '<h1 id="top">A</h1><a href="#top">up</a><a href="b.html#x">b</a>'
        clean = {"site/a.html": page, "site/b.html": '<p id="x"></p>'}
        done, _ = self.run_tool("check-links", clean, "--site", "site")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        done, _ = self.run_tool("check-links", {**clean, "site/b.html": "<p></p>"}, "--site", "site")
        self.assertEqual(done.returncode, 1)
        self.assertIn("site/a.html:1: b.html#x", done.stderr)


class Licences(Tree):
    SOURCES = {"a.cpp": "int a;\n", "run": "#!/bin/sh\ntrue\n", "page.md": "# Page\n", "CMakeLists.txt": "project(a)\n"}

    def test_lines_are_missed_and_added_once(self):
        done, left = self.run_tool("spdx", self.SOURCES, "--check")
        self.assertEqual((done.returncode, left), (1, self.SOURCES))
        for name in ("a.cpp", "run", "CMakeLists.txt"):
            self.assertIn(f"{name}:1: no licence line", done.stderr)
        done, left = self.run_tool("spdx", self.SOURCES)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(left, {"a.cpp": "// SPDX-License-Identifier: GPL-3.0-or-later\nint a;\n",
                                "run": "#!/bin/sh\n# SPDX-License-Identifier: GPL-3.0-or-later\ntrue\n",
                                "page.md": "# Page\n",
                                "CMakeLists.txt": "# SPDX-License-Identifier: GPL-3.0-or-later\nproject(a)\n"})
        done, again = self.run_tool("spdx", left, "--check")
        self.assertEqual((done.returncode, again), (0, left))


class Versions(Tree):
    def test_one_version(self):
        done, _ = self.run_tool("check-version", VERSIONS)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_another_version_or_day(self):
        self.finds("check-version", {**VERSIONS, "CMakeLists.txt": "project(triax VERSION 1.3.0 LANGUAGES CXX)\n"},
                   "CHANGELOG.md: its newest version is 1.2.3", "CITATION.cff: version 1.2.3")
        self.finds("check-version", {**VERSIONS, "CITATION.cff": "version: 1.2.3\ndate-released: 2026-01-05\n"}, "released 2026-01-05")


if __name__ == "__main__":
    unittest.main()
