#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""export_forms.py DATABASE --out FOLDER [--seed N]

Writes the simulated test of a database of triax as laboratories export it, one file for each form. No file has a stage column or a control
column, none has metadata beyond the dimensions, and none says how the test ended.
  raw                raw channels of the whole test, clock rounded to 1 s
  minute             the same, clock rounded to 1 min, so that times repeat
  held               the same as raw, but pressures that were held are printed as set, without noise
  reduced            time, axial strain, q, cell and pore pressure of shear; the volumetric strain if water could flow
  thinned            20 to 300 rows of that
  ends before, ends at, ends after, ends long after    one of raw, held and reduced, which ends before the loss, at the first reading that is
                     lost, some readings after 1 to 10 % of q was lost, or with a rest of the drive long after it; only if the
                     specimen was lost
"""
import argparse
import pathlib
import random as randomness
import sqlite3
import statistics
import sys

CHANNELS = {"axial_displacement_mm": ("Axial displacement (mm)", 4), "axial_force_kN": ("Axial force (kN)", 5),
            "cell_pressure_kPa": ("Cell pressure (kPa)", 2), "back_pressure_kPa": ("Back pressure (kPa)", 2),
            "pore_pressure_kPa": ("Pore pressure (kPa)", 2), "back_volume_mm3": ("Back volume (mm3)", 1)}
REDUCED = {"axial_strain": ("Axial strain (%)", 4), "volumetric_strain": ("Volumetric strain (%)", 4), "q_kPa": ("Deviator stress (kPa)", 2),
           "cell_pressure_kPa": ("Cell pressure (kPa)", 2), "pore_pressure_kPa": ("Pore pressure (kPa)", 2)}
HELD_KPA = 6.0       # range of the middle 90 % within which a pressure counts as held
MIN_ROWS, MAX_ROWS = 20, 300
CUTS = ("ends before", "ends at", "ends after", "ends long after")


class StoredTest:
    """Readings and truth of the one test of a database."""

    def __init__(self, database):
        with sqlite3.connect(f"file:{database}?mode=ro", uri=True) as db:
            db.row_factory = sqlite3.Row
            self.size = db.execute("SELECT height_mm, diameter_mm FROM specimens").fetchone()
            self.stages = {r["number"]: dict(r) for r in db.execute("SELECT * FROM stages")}
            self.rows = [dict(r) for r in db.execute(
                "SELECT s.*, s.q_Pa / 1000 AS q_kPa FROM scans s ORDER BY s.id")]
            truth = db.execute("SELECT * FROM truths").fetchone()
        for i, row in enumerate(self.rows):
            row["reading"] = i
        self.loss_s = truth["time_s"] if truth and truth["lost_sustainability"] else None

    def is_shear(self, row):
        return self.stages.get(row["stage"], {}).get("role") in ("shear", "hold")

    def shear(self):
        """From the first reading of shear on."""
        first = next((i for i, row in enumerate(self.rows) if self.stages.get(row["stage"], {}).get("role") == "shear"), len(self.rows))
        return [r for r in self.rows[first:] if self.is_shear(r)]

    def drained(self):
        return any(s["role"] == "shear" and s["drainage"] == "open" for s in self.stages.values())


def number(value, digits):
    return "" if value is None else f"{value:.{digits}f}"


def clock(seconds, step):
    """Time as logged: whole seconds, or whole minutes."""
    return f"{round(seconds)}" if step == 1 else f"{round(seconds / step)}"


def text_of(test, rows, columns, step=1.0, scale=None):
    lines = [f"Height (mm),{test.size['height_mm']:.2f}", f"Diameter (mm),{test.size['diameter_mm']:.2f}", ""]
    lines.append(",".join(["Time (s)" if step == 1 else "Time (min)"] + [heading for heading, _ in columns.values()]))
    for row in rows:
        cells = [number(None if row[key] is None else row[key] * (scale or {}).get(key, 1), digits) for key, (_, digits) in columns.items()]
        lines.append(",".join([clock(row["time_s"], step), *cells]))
    return "\n".join(lines) + "\n"


def raw_text(test, rows, step=1.0):
    return text_of(test, rows, {k: v for k, v in CHANNELS.items() if any(r[k] is not None for r in rows)}, step)


def reduced_text(test, rows):
    columns = {k: v for k, v in REDUCED.items() if k != "volumetric_strain" or test.drained()}
    complete = [r for r in rows if all(r[k] is not None for k in ("axial_strain", "q_kPa", "pore_pressure_kPa"))]
    return text_of(test, complete, columns, scale={"axial_strain": 100, "volumetric_strain": 100}), complete


def held(rows):
    """Pressures that were held in a stage, as they were set."""
    out = [dict(row) for row in rows]
    for stage in {row["stage"] for row in rows}:
        inside = [row for row in out if row["stage"] == stage]
        for key in ("cell_pressure_kPa", "back_pressure_kPa"):
            values = sorted(row[key] for row in inside if row[key] is not None)
            if len(values) >= 10 and values[round(0.95 * (len(values) - 1))] - values[round(0.05 * (len(values) - 1))] < HELD_KPA:
                for row in inside:
                    row[key] = float(round(statistics.median(values)))
    return out


def thinned(random, rows):
    """Rows at equal distances of time, or of the way along strain and q, as somebody reads them off a curve."""
    wanted = random.randint(MIN_ROWS, MAX_ROWS)
    if len(rows) <= wanted:
        return rows
    even = [rows[round(i * (len(rows) - 1) / (wanted - 1))] for i in range(wanted)]
    if random.random() < 0.5:
        return even

    def span(key):
        values = [r[key] or 0.0 for r in rows]
        return max(values) - min(values) or 1.0
    spans = {key: span(key) for key in ("axial_strain", "q_kPa", "pore_pressure_kPa")}
    out, last = [rows[0]], rows[0]
    for row in rows[1:]:
        way = sum(abs((row[k] or 0.0) - (last[k] or 0.0)) / spans[k] for k in spans)
        if way >= 3 / wanted:
            out.append(row)
            last = row
    out = out if out[-1] is rows[-1] else out + [rows[-1]]
    return out if MIN_ROWS <= len(out) <= MAX_ROWS else even


def at_rest(random, rows):
    """The drive has stopped and the logger goes on."""
    last, step = rows[-1], max(1.0, rows[-1]["time_s"] - rows[-2]["time_s"])
    out = list(rows)
    for i in range(random.randint(50, 300)):
        row = dict(last, time_s=last["time_s"] + step * (i + 1))
        for key, size in (("axial_displacement_mm", 1e-3), ("axial_force_kN", 1e-4), ("cell_pressure_kPa", 0.05), ("pore_pressure_kPa", 0.05),
                          ("back_pressure_kPa", 0.05), ("axial_strain", 5e-6), ("q_kPa", 0.05)):
            if row[key] is not None:
                row[key] += size * random.uniform(-1, 1)
        out.append(row)
    return out


def cut(random, rows, loss_s, how):
    """The rows that a record with this end has; None if the test has none of that kind."""
    at = next((i for i, row in enumerate(rows) if row["time_s"] >= loss_s), None)
    if at is None or at < 30:
        return None
    if how == "ends before":
        return rows[:round(at * random.uniform(0.8, 0.99))]
    if how == "ends at":
        return rows[:at + 1]
    if how == "ends after":
        weaker = abs(rows[at]["q_kPa"] or 0.0) * (1 - random.uniform(0.01, 0.1))
        end = next((i for i in range(at + 1, len(rows)) if abs(rows[i]["q_kPa"] or 0.0) < weaker), None)
        return end and rows[:end + random.randint(1, 7)]
    return at_rest(random, rows)


def forms(test, seed):
    """(form, text, original reading of each row) of a test."""
    def numbers(rows):
        return [row["reading"] for row in rows]
    random = randomness.Random(seed)
    shear = test.shear()
    if len(shear) < MIN_ROWS:
        return
    raw = {"raw": lambda rows: (raw_text(test, rows), rows), "held": lambda rows: (raw_text(test, held(rows)), rows),
           "reduced": lambda rows: reduced_text(test, [r for r in rows if r["reading"] >= shear[0]["reading"] and test.is_shear(r)])}
    yield "raw", raw["raw"](test.rows)[0], numbers(test.rows)
    yield "minute", raw_text(test, test.rows, 60.0), numbers(test.rows)
    yield "held", raw["held"](test.rows)[0], numbers(test.rows)
    text, rows = reduced_text(test, shear)
    yield "reduced", text, numbers(rows)
    text, rows = reduced_text(test, thinned(random, shear))
    yield "thinned", text, numbers(rows)
    if test.loss_s is None:
        return
    for how in CUTS:
        write = raw[random.choice(list(raw))]
        rows = cut(random, test.rows, test.loss_s, how)
        if rows:
            text, rows = write(rows)
            if len(rows) >= MIN_ROWS:
                yield how, text, numbers(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("database", type=pathlib.Path, metavar="DATABASE")
    parser.add_argument("--out", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("--seed", type=int, default=1, metavar="N")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    for name, text, _ in forms(StoredTest(options.database), options.seed):
        (options.out / f"{options.database.stem}.{name.replace(' ', '_')}.csv").write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
