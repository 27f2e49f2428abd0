# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/check-words and tools/check-commits on small repositories: clean ones pass, planted faults are found."""
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[2] / "tools"
GLOSSARY = """# Glossary

- **Assessment**: the result of a test. Instead of: verdict,
  sheet.

| Pattern | Write |
|---|---|
| `(?<!\\w)(anew\\|told)(?!\\w)` | a plain word |

| Name | Write |
|---|---|
| `\\bkMost[A-Z]` | kMax |
"""


class Repository(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)
        self.git("init", "-q")
        (self.root / "tools/remade").mkdir(parents=True)
        for name in ("check-words", "check-commits", "remade/markdown.py"):
            shutil.copy(TOOLS / name, self.root / "tools" / name)
        self.write("docs/glossary.md", GLOSSARY)
        self.write("lab/old.hpp", "constexpr int kMostOld = 1;  // told\n")
        self.commit("anything goes before the rule")

    def git(self, *arguments):
        subprocess.run(["git", "-c", "user.name=t", "-c", "user.email=t@t.invalid", *arguments], cwd=self.root, check=True,
                       capture_output=True)

    def write(self, name, text):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text, encoding="utf-8")

    def commit(self, message):
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", message)

    def run_tool(self, tool, *arguments):
        done = subprocess.run([sys.executable, self.root / "tools" / tool, *arguments], cwd=self.root, capture_output=True,
                              text=True, check=False)
        return done.returncode, done.stderr

    def words(self, page):
        self.write("docs/page.md", page)
        self.git("add", "-A")
        return self.run_tool("check-words")


class Texts(Repository):
    def texts(self, name, text):
        self.write(name, text)
        self.git("add", "-A")
        return self.run_tool("check-words", "--texts")

    def test_a_message_is_found_with_its_line_across_joined_literals(self):
        self.assertEqual(self.texts("src/a.cpp", '// told you so now\nfail("the result "\n     "is a verdict");\n'),
                         (1, 'src/a.cpp:2: "verdict": write "assessment"\n'))

    def test_the_page_is_checked(self):
        self.assertEqual(self.texts("src/page/web/js/a.js", "show(`this is a verdict ${verdict.of}`);\n")[0], 1)
        self.assertEqual(self.texts("src/page/web/index.html", "<p class='verdict'>\n<b>one verdict</b>\n")[1].count("index.html:2: "), 1)

    def test_sql_names_tags_and_semicolons_pass(self):
        self.assertEqual(self.texts("db/a.cpp", 'f("SELECT x FROM verdict v");\ng("member \\"verdict\\" is missing; "\n "did you mean '
                                                "'verdict'? a; b; c\", \"<p class=x verdict>a b c</p>\");\n"), (0, ""))

    def test_tests_are_not_checked(self):
        self.assertEqual(self.texts("tests/a.cpp", 'f("this is a verdict");\n'), (0, ""))


class Words(Repository):
    def test_clean_pages_pass(self):
        self.assertEqual(self.words("# Page\n\nThe `verdict` of\n\n    a verdict\n\n[x](verdict.md)\n"), (0, ""))

    def test_a_word_of_the_glossary_is_found_with_its_line(self):
        self.assertEqual(self.words("# Page\n\nGood.\nA Verdict.\n"), (1, 'docs/page.md:4: "verdict": write "assessment"\n'))

    def test_results_of_benchmarks_are_checked(self):
        self.write("bench/results/speed.md", "A verdict.\n")
        self.assertEqual(self.words("# Page\n"), (1, 'bench/results/speed.md:1: "verdict": write "assessment"\n'))

    def test_a_word_on_the_second_line_of_an_entry_counts(self):
        self.assertIn('"sheet": write "assessment"', self.words("# Page\n\nA sheet.\n")[1])

    def test_a_part_of_a_word_does_not_count(self):
        self.assertEqual(self.words("# Page\n\nA worksheet, a sheet-like thing.\n"), (0, ""))

    def test_a_sentence_pattern_is_found(self):
        self.assertEqual(self.words("# Page\n\nMade anew.\n"), (1, "docs/page.md:3: write: a plain word\n"))

    def test_long_lines_are_found_also_in_tables(self):
        self.assertIn("docs/page.md:3: 101 characters", self.words(f"# Page\n\n| {'x' * 97} |\n")[1])
        self.assertEqual(self.words(f"# Page\n\n{'x' * 100}\n"), (0, ""))

    def test_printed_output_may_be_long(self):
        self.assertEqual(self.words(f"# Page\n\n    {'x' * 200}\n"), (0, ""))

    def test_long_pages_are_found_unless_generated(self):
        self.assertIn("301 lines, at most 300", self.words("x\n" * 301)[1])
        self.assertEqual(self.words("<!-- Made by tools/x -->\n" + "x\n" * 301), (0, ""))
        self.assertEqual(self.words("<!-- numbers: x -->\n" + "x\n" * 301 + "<!-- end of numbers -->\n"), (0, ""))

    def test_a_glossary_without_rules_is_an_error(self):
        self.write("docs/glossary.md", "# Glossary\n")
        self.assertNotEqual(self.words("# Page\n")[0], 0)


class Touched(Repository):
    def test_lines_from_before_the_glossary_pass(self):
        self.assertEqual(self.run_tool("check-words", "--touched"), (0, ""))

    def test_new_names_and_comments_are_found(self):
        self.write("lab/new.hpp", '// It is told.\nconstexpr int kMostNew = 1;\nauto s = "kMostText";\n')
        self.commit("feat(lab): add a name")
        self.assertEqual(self.run_tool("check-words", "--touched"),
                         (1, "lab/new.hpp:1: write: a plain word\nlab/new.hpp:2: write: kMax\n"))


    def test_a_glossary_that_is_not_committed_is_not_in_force(self):
        shutil.rmtree(self.root / ".git")
        self.git("init", "-q")
        self.write("docs/glossary.md", GLOSSARY)
        self.write("lab/old.hpp", "")
        self.git("add", "lab")
        self.git("commit", "-q", "-m", "chore: begin")
        self.write("lab/old.hpp", "constexpr int kMostOld = 1;\n")
        self.assertEqual(self.run_tool("check-words", "--touched"), (0, ""))


class Commits(Repository):
    def check(self, message):
        self.commit(message)
        return self.run_tool("check-commits")

    def test_older_commits_and_good_ones_pass(self):
        self.assertEqual(self.check("fix(lab/base): add a subject\n\nBecause it is short.\n"), (0, ""))

    def test_bad_subjects_are_found(self):
        for bad in ("Add a thing", "fix: end with a stop.", "fixes(lab): unknown type", "fix(lab): " + "x" * 70):
            status, text = self.check(bad)
            self.assertEqual((status, "subject" in text), (1, True), bad)
            self.git("reset", "-q", "--hard", "HEAD~1")

    def test_a_long_body_line_is_found(self):
        self.assertIn("line 3 has 80 characters", self.check("fix: add a line\n\n" + "x" * 80)[1])

    def test_a_merge_is_found(self):
        self.git("checkout", "-q", "-b", "side")
        self.commit("fix: add one")
        self.git("checkout", "-q", "-")
        self.commit("fix: add two")
        self.git("merge", "-q", "--no-ff", "-m", "fix: join", "side")
        self.assertIn("merge commit", self.run_tool("check-commits")[1])


if __name__ == "__main__":
    unittest.main()
