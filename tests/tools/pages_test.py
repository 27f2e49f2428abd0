# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/pages on small trees with a triax of a few lines: what agrees passes, each difference is found."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[2] / "tools"

TRIAX = """#!/bin/sh
case "$*" in
  *--help) echo "--known N, for $1" ;;
  replay*) echo one; echo; echo "eta 0.58" ;;
  lost) echo "control is lost" >&2; exit 1 ;;
  "query 42 --format json") echo '[{"n": 42}]' ;;
  *) exit 2 ;;
esac
"""
BENCH = """#!/bin/sh
[ "$1" = --labels ] && n='#' || n=17.5
echo "elastic   $n ns"
echo "of 3 laws"
"""
NUMBERS = """from remade.benchmark import sampled, timed
def answer(triax): return f"It is {triax.query('42')[0]['n']}."
def speed(triax): return timed(triax, "bench/run.sh")
def table(triax): return sampled(triax, "bench/run.sh", "bench/run.sh --sample")
"""
PAGE = """# Page

<!-- transcript: shown -->
    $ triax replay a.csv
    one

    eta 0.58
    $ triax replay a.csv    # not shown
    $ triax replay a.csv
    one
    ...
    $ triax replay a.csv
    ...
    eta 0.58
    $ triax lost    # exit status 1
    control is lost
<!-- end of transcript -->

<!-- numbers: answer -->
It is 42.
<!-- end of numbers -->

    triax replay a.csv --known 3
"""


class Pages(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name)
        for name, text in {"docs/page.md": PAGE, "tools/numbers/page.py": NUMBERS, "triax": TRIAX, "bench/run.sh": BENCH,
                           "samples/a": "", ".gitignore": "triax\n"}.items():
            self.write(name, text)
        shutil.copy(TOOLS / "pages", self.root / "tools/pages")
        shutil.copytree(TOOLS / "remade", self.root / "tools/remade", ignore=shutil.ignore_patterns("__pycache__"))
        self.write("tools/remade/exceptions.toml", "")
        subprocess.run(["git", "init", "-q", self.root], check=True)
        self.git("add", ".")
        self.git("commit", "-q", "-m", "all")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        if text.startswith("#!"):
            path.chmod(0o755)

    def git(self, *arguments):
        subprocess.run(["git", "-c", "user.name=t", "-c", "user.email=t@example.invalid", *arguments], cwd=self.root, check=True)

    def page(self):
        return (self.root / "docs/page.md").read_text(encoding="utf-8")

    def pages(self, *arguments):
        return subprocess.run([sys.executable, self.root / "tools/pages", *arguments], capture_output=True, text=True, check=False,
                              env={**os.environ, "TRIAX": str(self.root / "triax")})

    def finds(self, page, *words):
        self.write("docs/page.md", page)
        done = self.pages("--check", "page")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stdout + done.stderr)
        self.assertEqual(self.page(), page)

    def test_a_page_that_agrees(self):
        done = self.pages("--check", "page")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_results_of_benchmarks_are_pages_and_names_are_unique(self):
        (self.root / "bench/results").mkdir()
        (self.root / "docs/page.md").rename(self.root / "bench/results/page.md")
        self.assertEqual(self.pages("--check", "page").returncode, 0)
        self.write("docs/page.md", PAGE)
        self.assertIn("have 2 pages of that name", self.pages("--check", "page").stderr)

    def test_each_difference_is_shown_and_made_anew(self):
        for right, wrong in (("    eta 0.58", "    eta 0.59"), ("It is 42.", "It is 41."), ("    one\n    ...", "    two\n    ..."),
                             ("    control is lost\n", "    control is kept\n")):
            page = PAGE.replace(right, wrong, 1)
            self.finds(page, f"-{wrong.splitlines()[0]}", f"+{right.splitlines()[0]}")
            self.assertEqual(self.pages("page").returncode, 0)
            self.assertEqual(self.page(), PAGE)

    def test_commands_run_in_order_and_the_wrong_ones_are_named(self):
        self.write("README.md", "# Readme\n\n    triax replay a.csv > a.txt\n\nThen\n\n    triax lost    # exit status 1\n    triax replay $(cat a.txt)\n")
        self.assertEqual(self.pages("--run", "README").returncode, 0)
        self.write("README.md", "# Readme\n\n    triax replay a.csv\n\nThen\n\n    triax nonsense\n")
        self.write("tools/remade/not_run.toml", "")
        done = self.pages("--run")
        self.assertEqual(done.returncode, 1)
        self.assertIn("README: exit status 2, not 0: triax nonsense", done.stderr)
        self.write("tools/remade/not_run.toml", '[README]\n"triax nonsense" = "fails"\n"triax gone" = "is on no page"\n')
        self.assertIn("README: not_run.toml lists a block that the page does not have: triax gone", self.pages("--run", "README").stderr)

    def test_a_server_runs_until_the_end_of_its_page(self):
        self.write("triax", "#!/bin/sh\ncase $1 in serve) echo $$ >pid; exec sleep 60 ;; ask) kill -0 $(cat pid) ;; esac\n")
        self.write("tools/remade/not_run.toml", "")
        self.write("README.md", "# Readme\n\n    triax serve rig.toml\n\nThen\n\n    triax ask\n")
        self.assertEqual(self.pages("--run", "README").stderr, "")
        self.write("triax", "#!/bin/sh\necho no rig >&2; exit 1\n")
        self.assertIn("no rig", self.pages("--run", "README").stderr)

    def test_a_status_that_is_not_said(self):
        self.finds(PAGE.replace("    # exit status 1", ""), "status 1")

    def test_a_block_that_is_not_closed(self):
        self.finds(PAGE.replace("<!-- end of numbers -->", ""), "not closed")

    def test_an_option_that_there_is_not(self):
        self.finds(PAGE.replace("--known", "--unknown"), "--unknown is no option of triax replay")
        self.finds(PAGE + "\nSee `triax replay --other`.\n", "--other is no option")

    def test_the_words_of_a_benchmark_are_checked_and_its_figures_are_nobodys_to_change(self):
        self.write("docs/page.md", "<!-- numbers: speed -->\n<!-- end of numbers -->\n")
        self.assertEqual(self.pages("page").returncode, 0)
        made = self.page()
        self.assertIn("    elastic   17.5 ns\n    of 3 laws\n", made)
        self.assertEqual(self.pages("--check", "page").returncode, 0)
        self.finds(made.replace("17.5", "17.4"), "by no other hand")
        self.write("bench/run.sh", BENCH.replace("3 laws", "4 laws"))
        self.finds(made, "+    of 4 laws")
        self.write("bench/run.sh", BENCH.replace("17.5", "99.9"))  # a slower machine
        self.write("docs/page.md", made)
        self.assertEqual(self.pages("--check", "page").returncode, 0)

    def test_a_sample_stands_for_a_long_benchmark(self):
        self.write("docs/page.md", "<!-- numbers: table -->\n<!-- end of numbers -->\n")
        self.assertEqual(self.pages("page").returncode, 0)
        made = self.page()
        self.assertEqual(self.pages("--check", "page").returncode, 0)
        self.finds(made.replace("3 laws", "4 laws"), "a hand changed this")
        self.write("bench/run.sh", BENCH.replace("3 laws", "4 laws"))
        self.finds(made, "prints something else")

    def unchecked(self, page, exceptions=""):
        self.write("docs/page.md", page)
        self.write("tools/remade/exceptions.toml", exceptions)
        done = self.pages("--unchecked")
        return done.returncode, done.stderr

    def test_output_that_no_command_makes_is_found(self):
        self.assertEqual(self.unchecked(PAGE), (0, ""))
        output = PAGE + "\nIt says\n\n    eta 0.58\n    phi 15\n"
        status, told = self.unchecked(output)
        self.assertEqual(status, 1)
        self.assertIn("docs/page.md: no command makes: eta 0.58", told)
        self.assertEqual(self.unchecked(output, '["docs/page.md"]\n"eta 0.58" = "of others"\n'), (0, ""))
        for more in ("```\neta 0.58\n```\n", "| a | b | c |\n|---|---|---|\n| x | 0.58 | 15.2° |\n"):
            self.assertEqual(self.unchecked(PAGE + "\n" + more)[0], 1, more)
        self.assertEqual(self.unchecked(PAGE + "\n| a | b |\n|---|---|\n| x | 0.58 |\n"), (0, ""))

    def test_a_benchmark_that_was_stopped_changes_no_page(self):
        page = "<!-- numbers: table -->\n<!-- end of numbers -->\n"
        self.write("docs/page.md", page)
        self.write("bench/run.sh", "#!/bin/sh\necho half\nkill -TERM $$\n")
        done = self.pages("page")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("bench/run.sh: status", done.stderr)
        self.assertEqual(self.page(), page)

    def test_an_exception_for_nothing_is_found(self):
        self.assertIn("lists a text that the page does not have: eta", self.unchecked(PAGE, '["docs/page.md"]\n"eta" = "of others"\n')[1])
        self.assertIn("there is no docs/gone.md", self.unchecked(PAGE, '["docs/gone.md"]\n"*" = "of others"\n')[1])


if __name__ == "__main__":
    unittest.main()
