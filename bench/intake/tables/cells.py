# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells of the columns: the readings of a test in the units, signs and number format of the file."""
import datetime
from dataclasses import replace

from . import clocks


def display(texts, traits):
    """Plain numbers as this file writes them."""
    style, comma, thousands = traits["numbers"], traits["decimal"] == "comma", traits["thousands"]
    if thousands != "none":
        mark = {"comma": ",", "point": ".", "nbsp": "\u00a0", "apostrophe": "'"}[thousands]
        point = "," if comma else "."
        out = []
        for text in texts:
            whole, dot, rest = text.partition(".")
            digits = whole.lstrip("-")
            if len(digits) > 3:
                whole = ("-" if whole[0] == "-" else "") + f"{int(digits):,}".replace(",", mark)
            out.append(whole + (point + rest if dot else ""))
        return out
    if style == "no_leading_zero":
        texts = [t.replace("0.", ".", 1) if t.startswith(("0.", "-0.")) else t for t in texts]
    elif style == "unicode_minus":
        texts = [t.replace("-", "−") for t in texts]
    elif style == "explicit_plus":
        texts = [t if t[0] == "-" else "+" + t for t in texts]
    return [t.replace(".", ",") for t in texts] if comma else texts


def numbers_of(random, column, test, traits):
    """Canonical values of the column, before they are rounded."""
    series, rows = test.series, len(test.series["time"])
    if column.quantity == "reading_number":
        first = random.choice([0, 1, 1])
        return [first + i for i in range(rows)]
    if column.quantity == "stage":
        first = test.series.setdefault("first_stage", random.choice([0, 1, 1]))
        return [first + s for s in test.stages]
    if column.quantity == "temperature":
        return [21 + random.uniform(-0.4, 0.4) for _ in range(rows)]
    if column.quantity == "ignored":
        return [test.cell] * rows
    if column.quantity == "cell_volume":
        return [random.uniform(-20, 20) + 150.0 * i / rows for i in range(rows)]
    if column.quantity == "force_reading":
        return [f / 0.00182 for f in series["axial_force"]]
    if column.quantity == "back_pressure":
        back = test.back if "back_pressure" not in series else series["back_pressure"]
        return [back + (random.uniform(-0.05, 0.05) if traits["noise"] == "yes" else 0.0) for _ in range(rows)]
    if column.quantity == "specimen_height":
        return [test.height] * rows if column.extra.setdefault("constant", random.random() < 0.5) else series["specimen_height"]
    return series[column.quantity]


def fill_number(random, column, test, traits):
    scale = 1 / (column.factor * column.sign)
    exponent = traits["numbers"] == "exponent" and column.unit_source != "name"
    form = f"%.{4 if column.decimals else 3}E" if exponent else f"%.{column.decimals}f"
    zero = form % 0
    column.plain = [zero if t == "-" + zero else t for t in [form % (v * scale) for v in numbers_of(random, column, test, traits)]]
    column.cells = list(display(column.plain, traits))


def fill_clock(column, test, traits, begin):
    form, times = column.form, test.series["time"]
    if form == "h:mm:ss":
        column.plain = [str(t) for t in times]
        column.cells = [clocks.elapsed(t) for t in times]
        return
    column.moments = moments = [begin + datetime.timedelta(seconds=t) for t in times]
    if form == "excel serial":
        column.cells = [f"{clocks.serial(t):.6f}" for t in moments]
        if traits["decimal"] == "comma":
            column.cells = [c.replace(".", ",") for c in column.cells]
    elif form.startswith("unix"):
        factor = 1000 if form.endswith("ms") else 1
        column.cells = [str(int((t - clocks.EPOCH).total_seconds()) * factor) for t in moments]
    elif form == "xlsx date":
        column.cells = [clocks.serial(t) for t in moments]
    else:
        bare = traits["clock"] == "midnight_bare"
        column.cells = [clocks.write(t, form.split(" ")[0] if bare and t.hour == t.minute == t.second == 0 else form,
                                     traits["language"], column.unpadded) for t in moments]
        if traits["clock"] == "date_on_change" and column.quantity == "date":
            column.cells = [c if i == 0 or c != column.cells[i - 1] else "" for i, c in enumerate(column.cells)]


def filled(plan, random, test, begin, number):
    """Copies of the plan's columns with the cells of one test."""
    out = []
    for planned in plan.columns:
        column = replace(planned, plain=[], cells=[], moments=[], extra=dict(planned.extra), test=number)
        if column.quantity == "text":
            column.cells = [random.choice(["", "", "", "ok", "log"]) for _ in test.series["time"]]
        elif column.form:
            fill_clock(column, test, plan.traits, begin)
        elif column.quantity == "stage" and plan.traits["stage_cells"] == "words":
            words = plan.names.words("stages")
            column.cells = [words[s] for s in test.stages]
            column.extra["check"] = "words: saturation, consolidation, shear"
            column.form = "words"
        else:
            fill_number(random, column, test, plan.traits)
        column.extra.pop("constant", None)
        out.append(column)
    return out
