# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that go out as workbooks, and what triax itself says of their states."""
import csv
import math
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("TRIAX", str(ROOT / "build/release/triax"))
SKIPPED = 77
FIRST_STATE = 3  # row of the sheet
EVIL = "=1+1, \"quoted\""
REDUCED = ["axial_strain,deviator_stress_kPa,mean_effective_stress_kPa"] + [
    f"{i * 1e-3:.3f},{40 * i / (i + 9) - 0.3 * i:.4f},{100 - 1.3 * i + 0.004 * i * i:.4f}" for i in range(60)]


def triax(folder, *arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, capture_output=True, text=True)


def expect(found, wanted, what):
    if found != wanted:
        sys.exit(f"{what}: {found!r} instead of {wanted!r}")


def thinned(record, every, into):
    """The record with every so many-th of its readings."""
    lines = (ROOT / record).read_text().splitlines()
    rows = [i for i, line in enumerate(lines) if not line.startswith("#")][1:]
    left_out = set(rows) - set(rows[::every])
    into.write_text("\n".join(line for i, line in enumerate(lines) if i not in left_out) + "\n")


def export_all(folder):
    """Workbooks of simulated tests without and with a membrane, and of a record of stresses: {file: states by triax}."""
    membrane = ["--set", "specimen.membrane_thickness_mm=0.3", "--set", "specimen.membrane_modulus_kPa=1400"]
    (folder / "evil.csv").write_text(f"# [test]\n# name = '{EVIL}'\n# [specimen]\n# material = '@SUM(1)'\n# void_ratio = 0.8\n"
                                     + "\n".join(REDUCED) + "\n")
    thinned("samples/records/icu_6.csv", 4, folder / "icu.csv")
    thinned("samples/records/csd_58.csv", 4, folder / "csd.csv")
    for record, more in (("icu.csv", []), ("csd.csv", ["--membrane", "iso", *membrane]), ("icu.csv", ["--membrane", "astm", *membrane]),
                         ("evil.csv", [])):
        ended = triax(folder, "replay", record, *more)
        expect(ended.returncode, 0, ended.stderr)
    tests = {}
    for number in (1, 2, 3, 4):
        for arguments in (["--format", "xlsx", "--output", f"{number}.xlsx"], ["--format", "csv", "--states", "--output", f"{number}.csv"]):
            ended = triax(folder, "export", number, *arguments)
            expect((ended.returncode, "of states are numbers" in ended.stderr), (0, False), ended.stderr)
        with open(folder / f"{number}.csv", newline="") as file:
            tests[folder / f"{number}.xlsx"] = list(csv.DictReader(file))
    return tests


def forget_values(book, into):
    """A copy in which every formula had come to 0 when it was saved."""
    with zipfile.ZipFile(book) as old, zipfile.ZipFile(into, "w", zipfile.ZIP_DEFLATED) as new:
        for part in old.namelist():
            data = old.read(part)
            if part.startswith("xl/worksheets/"):
                data, changed = re.subn(rb"(</f>)<v>[^<]*</v>", rb"\1<v>0</v>", data)
            new.writestr(part, data)


def hold_to(states, rows, who):
    """States that a spreadsheet came to, a list of {heading: number}, beside ours: q, p′, e and the others to a part in 10^12 (of
    1 where they are smaller; η and φ by as much less as p′ is below 1 kPa), second-order work to 10^-12."""
    expect(len(rows), len(states), f"{who}: rows")
    compared = 0
    for ours, theirs in zip(states, rows):
        for heading, text in ours.items():
            if text == "":
                continue
            wanted, found = float(text), theirs[heading]
            if heading == "mobilised_friction_angle_deg":  # near 90° a last bit of the stresses is seen in its tenth digit
                wanted, found = math.sin(math.radians(wanted)), math.sin(math.radians(found))
            small_p = max(1, 1 / abs(float(ours["mean_effective_stress_kPa"]) or 1)) if heading in ("stress_ratio", "mobilised_friction_angle_deg") else 1
            bound = 1e-12 if heading == "second_order_work_normalised" else 1e-12 * max(1, abs(wanted)) * small_p
            if not abs(found - wanted) <= bound:
                sys.exit(f"{who}: {heading} of reading {ours['reading']} is {found!r} instead of {wanted!r}")
            compared += 1
    return compared
