# SPDX-License-Identifier: GPL-3.0-or-later
"""LibreOffice computes every formula of exported workbooks anew, from readings alone, and comes to our states."""
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
import zipfile
from pathlib import Path

from workbooks import FIRST_STATE, SKIPPED, export_all, forget_values, hold_to

if not shutil.which("soffice"):
    print("skipped: no soffice (tools/packages-test.txt)")
    sys.exit(SKIPPED)

ALWAYS = """<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry"><item oor:path="/org.openoffice.Office.Calc/Formula/Load">
<prop oor:name="OOXMLRecalcMode" oor:op="fuse"><value>0</value></prop></item></oor:items>"""
MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"


def states_of(book):
    """The rows of the sheet "states" as the values that were saved."""
    with zipfile.ZipFile(book) as parts:
        names = [sheet.get("name") for sheet in xml.fromstring(parts.read("xl/workbook.xml")).iter(MAIN + "sheet")]
        texts = ["".join(t.text or "" for t in si.iter(MAIN + "t")) for si in xml.fromstring(parts.read("xl/sharedStrings.xml"))]
        sheet = xml.fromstring(parts.read(f"xl/worksheets/sheet{names.index('states') + 1}.xml"))
    headings, rows = {}, []
    for row in sheet.iter(MAIN + "row"):
        number, cells = int(row.get("r")), {}
        for cell in row.iter(MAIN + "c"):
            value = cell.find(MAIN + "v")
            if value is None or number < FIRST_STATE - 1:
                continue
            column = re.match("[A-Z]+", cell.get("r"))[0]
            if number == FIRST_STATE - 1:
                headings[column] = texts[int(value.text)]
            else:
                cells[headings[column]] = float(value.text)
        if cells:
            rows.append(cells)
    return rows


with tempfile.TemporaryDirectory() as made:
    folder = Path(made)
    tests = export_all(folder)
    (folder / "profile/user").mkdir(parents=True)
    (folder / "profile/user/registrymodifications.xcu").write_text(ALWAYS)
    (folder / "forgot").mkdir()
    for book in tests:
        forget_values(book, folder / "forgot" / book.name)
    subprocess.run(["soffice", f"-env:UserInstallation=file://{folder}/profile", "--headless", "--convert-to", "xlsx", "--outdir",
                    folder / "computed", *(folder / "forgot" / book.name for book in tests)], check=True, capture_output=True, timeout=280)
    for book, states in tests.items():
        print(book.name, hold_to(states, states_of(folder / "computed" / book.name), f"LibreOffice, {book.name}"), "numbers")
