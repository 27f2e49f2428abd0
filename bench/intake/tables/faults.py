# SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of a record: fill values, missing cells, rows in reverse order."""

FILLS = {"-999.25": ["-999.25"], "-9999": ["-9999", "-9999.0"], "1e30": ["1E+30", "1.0E+30"], "9.9E37": ["9.9E37", "9.90000E+37"],
         "NaN": ["NaN", "NAN", "nan"], "OVRFLO": ["OVRFLO"], "OVERLOAD": ["OVERLOAD", "OL"], 
         "dash": ["-", "--", "---"], "n/a": ["n/a", "N/A"], "blank": [""], "#DIV/0!": ["#DIV/0!", "#N/A"]}
NEVER = {"time", "stage_time", "stage", "cycle", "reading_number", "temperature", "ignored", "specimen_height", "cell_volume"}


def fill(random, columns, traits):
    """Puts the fill value into one to three runs of cells, never into the last reading. Returns the (row, column) pairs, from 0."""
    if traits["fill"] == "none":
        return set()
    token = random.choice(FILLS[traits["fill"]])
    if traits["decimal"] == "comma":
        token = token.replace(".", ",")
    opening = {"excess_pore_pressure", "back_volume", "volume_change", "volumetric_strain", "void_ratio"}  # whose first readings decide
    candidates = [i for i, c in enumerate(columns) if c.is_number and c.quantity not in NEVER]
    rows = len(columns[0].cells)
    missing = set()
    for _ in range(random.randint(1, 3)):
        at, begin = random.choice(candidates), random.choice([0, random.randrange(rows - 2)])
        if columns[at].quantity in opening:
            begin = max(begin, rows // 3)
        for row in range(begin, min(begin + random.choice([1, 1, 2, 3]), rows - 4)):
            if len({i for r, i in missing if r == row} | {at}) < len(candidates):  # a row without any value is none
                missing.add((row, at))
    for row, at in missing:
        columns[at].cells[row] = token
    return missing


def reverse(columns):
    for column in columns:
        column.cells.reverse()
        column.plain.reverse()
        column.moments.reverse()
