# SPDX-License-Identifier: GPL-3.0-or-later
# Reads recorded tests and their labels, and scores warnings. Used by fit_cyclic.py and score.py.
import csv
import math
import pathlib
import typing

METHODS = ("onset_authors", "onset_peak_q", "onset_r_u")


class Row(typing.NamedTuple):
    q: float  # kPa
    p: float  # p', kPa
    strain: float  # axial, %, compression positive


def split(line):
    for separator in (";", ",", "\t"):
        if separator in line:
            return [field.strip() for field in line.split(separator)]
    return line.split()


def read_rows(path, columns):
    """Rows of a table. `columns` has the places of q, p' and axial strain, as "7:8:1" (from 1). A
    factor may follow a place: "1*100" is a fraction. Lines without these numbers are left out."""
    places = [column.partition("*")[::2] for column in columns.split(":")]
    places = [(int(place) - 1, float(factor or 1)) for place, factor in places]
    rows = []
    for line in path.read_text(encoding="utf-8-sig", errors="replace").splitlines():
        fields = split(line)
        try:
            values = [float(fields[place]) * factor for place, factor in places]
        except (IndexError, ValueError):
            continue
        if all(map(math.isfinite, values)):
            rows.append(Row(*values))
    return rows


def number(text):
    return int(text) if text.strip() else None


def read(folder, labels):
    """Tests with their rows, and the names of the records that are missing."""
    tests, missing = [], []
    with open(labels, newline="", encoding="utf-8") as file:
        lines = [line for line in file if not line.startswith("#")]
    for label in csv.DictReader(lines):
        path = pathlib.Path(folder, label["file"])
        if not path.exists():
            missing.append(label["file"])
            continue
        onsets = {method: number(label[method]) for method in METHODS}
        test = {
            "name": path.stem,
            "path": path,
            "type": label["type"],
            "kind": label["kind"],
            "replay": label["replay"].split(),
            "rows_per_cycle": number(label["rows_per_cycle"]),
            "fit": label["fit"] == "yes",
            "onsets": {m: row for m, row in onsets.items() if row is not None},
            "rows": read_rows(path, label["columns"]),
        }
        test["onset"] = next(iter(test["onsets"].values()), None)
        tests.append(test)
    return tests, missing


class WarningScore:
    """Score of a warning that is in force or not at each row of a cyclic test."""

    def __init__(self):
        self.hits = self.false = self.missed = 0  # windows
        self.tests = self.standing = 0
        self.withdrawn = self.most_withdrawn = 0
        self.early = self.rows = 0
        self.leads = []  # cycles

    def add(self, test, levels):
        onset, cycle = test["onset"], test["rows_per_cycle"]
        for end in range(cycle - 1, onset + 1, max(1, cycle // 8)):
            is_true = onset - end <= cycle
            self.hits += levels[end] and is_true
            self.false += levels[end] and not is_true
            self.missed += is_true and not levels[end]
        self.tests += 1
        self.standing += bool(levels[onset])
        withdrawn = sum(a and not b for a, b in zip(levels[:onset], levels[1 : onset + 1]))
        self.withdrawn += withdrawn
        self.most_withdrawn = max(self.most_withdrawn, withdrawn)
        self.early += sum(map(bool, levels[: max(0, onset - 2 * cycle)]))
        self.rows += onset + 1
        first = onset + 1
        while first > 0 and levels[first - 1]:
            first -= 1
        self.leads.append((onset + 1 - first) / cycle)

    @property
    def f1(self):
        found = 2 * self.hits + self.false + self.missed
        return 2 * self.hits / found if found else 0.0

    def text(self):
        lead = sorted(self.leads)[len(self.leads) // 2]
        return (f"F1 {self.f1:.3f}, lead {lead:.2f}, in force {self.standing} of {self.tests}, "
                f"withdrawn {self.withdrawn} ({self.most_withdrawn}), early {100 * self.early / self.rows:.2f} %")
