# SPDX-License-Identifier: GPL-3.0-or-later
"""gnumeric reads exported workbooks, computes their formulas anew and comes to our states."""
import csv
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from workbooks import FIRST_STATE, SKIPPED, export_all, forget_values, hold_to

if not shutil.which("ssconvert"):
    print("skipped: no ssconvert (tools/packages-test.txt)")
    sys.exit(SKIPPED)

with tempfile.TemporaryDirectory() as made:
    folder = Path(made)
    for book, states in export_all(folder).items():
        forget_values(book, folder / "forgot.xlsx")
        subprocess.run(["ssconvert", "--recalc", "-T", "Gnumeric_stf:stf_assistant", "-O", "sheet=states separator=, format=raw",
                        "forgot.xlsx", "states.txt"], cwd=folder, check=True, capture_output=True)
        with open(folder / "states.txt", newline="") as file:
            rows = list(csv.reader(file))
        headings = rows[FIRST_STATE - 2]
        values = [{h: float(v) for h, v in zip(headings, row) if v != ""} for row in rows[FIRST_STATE - 1:]]
        print(book.name, hold_to(states, values, f"gnumeric, {book.name}"), "numbers")
