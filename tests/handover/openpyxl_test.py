# SPDX-License-Identifier: GPL-3.0-or-later
"""openpyxl reads exported workbooks: sheets, formulas with the values of the last save, texts that are no formulas, the word SIMULATED."""
import sys
import tempfile
from pathlib import Path

from workbooks import EVIL, FIRST_STATE, SKIPPED, expect, export_all, hold_to

sys.path.append("/usr/lib/python3/dist-packages")
try:
    import openpyxl
except ImportError as missing:
    print(f"skipped: {missing} (tools/packages-test.txt)")
    sys.exit(SKIPPED)

SHEETS = ["specimen", "stages", "readings", "states", "blocks", "verdict", "charts"]

with tempfile.TemporaryDirectory() as made:
    folder = Path(made)
    for book, states in export_all(folder).items():
        saved, live = openpyxl.load_workbook(book, data_only=True), openpyxl.load_workbook(book)
        expect(saved.sheetnames, SHEETS, "sheets")
        simulated = "4" not in book.name
        for sheet in saved:
            expect("SIMULATED" in sheet["A1"].value, simulated, f"{book.name}, {sheet.title}: {sheet['A1'].value}")
        headings = [cell.value for cell in saved["states"][FIRST_STATE - 1]]
        rows = [{h: v for h, v in zip(headings, row) if v is not None}
                for row in saved["states"].iter_rows(min_row=FIRST_STATE, values_only=True)]
        print(book.name, hold_to(states, rows, f"openpyxl, {book.name}"), "numbers")
        for row, ours in zip(live["states"].iter_rows(min_row=FIRST_STATE), states):
            for heading, cell in zip(headings, row):
                followed = heading in ours and heading not in ("reading", "second_order_work_error") and ours[heading] != ""
                if followed and cell.data_type != "f":
                    sys.exit(f"{book.name}: {heading} in {cell.coordinate} is no formula but {cell.value!r}")
        # No text became a formula: those that are begin as ours do.
        for sheet in live:
            for row in sheet.iter_rows():
                for cell in row:
                    if cell.data_type == "f" and ("1+1" in cell.value or "@" in cell.value or "HYPERLINK" in cell.value):
                        sys.exit(f"{book.name}: {sheet.title}!{cell.coordinate} is the formula {cell.value}")
        if not simulated:
            words = [str(cell.value) for row in saved["specimen"].iter_rows() for cell in row] + [saved["charts"]["A1"].value]
            expect(any(EVIL in word for word in words), True, "the test's name, as a text")
        answers = [row[1] for row in saved["verdict"].iter_rows(values_only=True) if row[0] == "answer"]
        expect(len(answers) == 1 and answers[0] in ("collapse", "none", "not assessed"), True, f"one of three answers: {answers}")
        expect(len(live["charts"]._charts) in (0, 4), True, "charts")
