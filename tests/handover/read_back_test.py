# SPDX-License-Identifier: GPL-3.0-or-later
"""Workbooks as openpyxl, gnumeric and LibreOffice write them are read as the CSV that they come from: dates of 1900 and of 1904, clocks, per cent,
decimal commas, texts, rich texts, formulas, merged cells and hidden sheets among them."""
import datetime
import json
import math
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from workbooks import SKIPPED, expect, triax

START = datetime.datetime(2019, 2, 11, 6, 30, 24)
HEADINGS = ["time_s", "axial_strain (%)", "deviator_stress_kPa", "mean_effective_stress_kPa"]
ROWS = [(i * 0.5, i * 2.5e-4, round(40 * i / (i + 9) - 0.3 * i, 4), round(100 - 1.3 * i + 0.004 * i * i, 4)) for i in range(60)]


def told(folder, record, number):
    """The states of a record, a list of values each."""
    ended = triax(folder, "replay", record)
    expect(ended.returncode, 0, f"{record}: {ended.stderr}")
    ended = triax(folder, "export", number, "--format", "json")
    return json.loads(ended.stdout)["states"]["rows"]


def same(ours, theirs, who):
    def close(a, b):
        return a == b or (isinstance(a, float) and isinstance(b, float) and math.isclose(a, b, rel_tol=1e-12, abs_tol=1e-9))
    if isinstance(ours, list):
        expect(len(theirs), len(ours), who)
        for i, (a, b) in enumerate(zip(ours, theirs)):
            same(a, b, f"{who} {i}")
    elif not close(ours, theirs):
        sys.exit(f"{who}: {theirs!r} instead of {ours!r}")


def by_openpyxl(path, epoch_1904):
    import openpyxl
    from openpyxl.utils.datetime import CALENDAR_MAC_1904
    book = openpyxl.Workbook()
    if epoch_1904:
        book.epoch = CALENDAR_MAC_1904
    book.active.title = "Notes"
    book.active.merge_cells("A1:D4")
    book.active["A1"] = "Versuch, gelesen am Montag"
    hidden = book.create_sheet("Old")
    hidden.sheet_state = "hidden"
    hidden.append(HEADINGS)
    hidden.append([START, 9, 9, 9])
    sheet = book.create_sheet("Data")
    sheet.append(HEADINGS)
    for i, (time, strain, q, p) in enumerate(ROWS):
        sheet.append([START + datetime.timedelta(seconds=time), strain, str(q).replace(".", ",") if i % 7 == 3 else q, p])
        row = sheet.max_row
        sheet.cell(row, 1).number_format = "dd.mm.yyyy hh:mm:ss.000"
        sheet.cell(row, 2).number_format = "0.000%"
    sheet.merge_cells("F1:G9")
    book.save(path)


def main():
    here = Path(tempfile.mkdtemp())
    try:
        (here / "plain.csv").write_text(",".join(HEADINGS) + "\n" + "".join(
            f"{(START + datetime.timedelta(seconds=t)).isoformat(' ', 'milliseconds')},{strain * 100:.10g},{q},{p}\n" for t, strain, q, p in ROWS))
        ours = told(here, "plain.csv", 1)
        expect(len(ours), len(ROWS), "states of the CSV")
        count, missing = 1, []
        try:
            import openpyxl  # noqa: F401
            for epoch_1904 in (False, True):
                name = f"openpyxl_{1904 if epoch_1904 else 1900}.xlsx"
                by_openpyxl(here / name, epoch_1904)
                count += 1
                same(ours, told(here, name, count), name)
        except ImportError:
            missing.append("python3-openpyxl")
        converters = (("ssconvert", ["ssconvert", "--export-type=Gnumeric_Excel:xlsx2", "{from}", "{to}"], "gnumeric.xlsx"),
                      ("soffice", ["soffice", f"-env:UserInstallation=file://{here}/office", "--headless", "--convert-to", "xlsx:Calc MS Excel 2007 XML", "--outdir",
                                   "{folder}", "{from}"], "plain.xlsx"))
        for program, command, name in converters:
            if not shutil.which(program):
                missing.append(program)
                continue
            words = {"from": here / "plain.csv", "to": here / name, "folder": here}
            subprocess.run([word.format(**words) for word in command], capture_output=True, timeout=250, check=True, cwd=here)
            count += 1
            same(ours, told(here, name, count), name)
        if missing:
            print("skipped: no " + ", ".join(missing))
            sys.exit(SKIPPED if count == 1 else 0)
    finally:
        shutil.rmtree(here)


main()
