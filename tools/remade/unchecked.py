# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands on pages as if the program had said it, and comes from no command.

That is every block of code that holds more than commands, and every table of figures (a row with two cells that are numbers), outside of
what tools/pages makes. Those that are meant so stand with their reason in exceptions.toml, by their first line, or "*" for a whole page.
"""
import re
import subprocess
import sys
import tomllib

from remade.program import ROOT

EXCEPTIONS = ROOT / "tools/remade/exceptions.toml"
WHOLE = "<!-- Made by tools/"  # first line of a page that is made whole
FENCED = re.compile(r"^( *)```.*\n(?P<body>(?:.*\n)*?)\1```$", re.M)
INDENTED = re.compile(r"(?:\A|(?<=\n\n))(?P<body>(?:(?: {4}).*(?:\n|\Z)|\n(?= {4}))+)")
COMMAND = re.compile(r"(?:\$ )?(?:build/\S+/)?(?:triax|tools/|\.ci/|bench/|cmake|apt-get|gfortran|mkdir|for |cp |sed |cat (?!>))")
CELL = re.compile(r"[-+−±]?\d[\d  .,]*(?: ?(?:%|°|s|kPa|ns|mm|MB|kB|x))?")


def only_commands(body: str) -> bool:
    lines = re.sub(r"\\\n", " ", body).strip("\n").split("\n")
    return all(COMMAND.match(line.strip()) for line in lines if line.strip())


def first_line(body: str) -> str:
    return body.strip("\n").split("\n")[0].strip()


def tables(text: str) -> list[str]:
    """The heads of those with figures."""
    found = []
    for table in re.findall(r"(?:^ *\|.*\n)+", text + "\n", re.M):
        rows = [[cell.strip().strip("*") for cell in row.strip().strip("|").split("|")] for row in table.strip().split("\n")]
        if any(sum(bool(CELL.fullmatch(cell)) for cell in row) > 1 for row in rows[2:]):
            found.append(first_line(table))
    return found


def of_page(text: str) -> list[str]:
    bodies = [m["body"] for m in FENCED.finditer(text)]
    text = FENCED.sub("", text)
    # A list's own paragraphs are indented too: code there is fenced.
    bodies += [m["body"] for m in INDENTED.finditer(text)]
    return [first_line(body) for body in bodies if not only_commands(body)] + tables(text)


def report(blocks: re.Pattern) -> int:
    pages = subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    excepted = tomllib.loads(EXCEPTIONS.read_text(encoding="utf-8"))
    wrong = []
    for page in pages:
        text = (ROOT / page).read_text(encoding="utf-8")
        reasons = excepted.pop(page, {})
        if text.startswith(WHOLE) or "*" in reasons:
            continue
        for key in of_page(blocks.sub("\n", text)):
            if not reasons.pop(key, None):
                wrong.append(f"{page}: no command makes: {key}\n  let tools/pages make it, or say in {EXCEPTIONS.name} why not")
        wrong += [f"{page}: exceptions.toml lists a text that the page does not have: {key}" for key in reasons]
    wrong += [f"exceptions.toml: there is no {page}" for page in excepted]
    print(*wrong, sep="\n", end="\n" if wrong else "", file=sys.stderr)
    return 1 if wrong else 0
