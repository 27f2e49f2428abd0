# SPDX-License-Identifier: GPL-3.0-or-later
"""What a file does not contain, so that a reader has to ask for it."""
from . import clocks
from .columns import EFFECTIVE, STRESSES, TOTAL, VOLUMES
from .specimen import TOTAL_STRESS
from .units import DIMENSION


def order_is_open(tests):
    """True if no clock of the file, given as one list of columns for each test, decides the order of day and month."""
    dated = [c for columns in tests for c in columns if c.quantity in ("clock", "date") and "%d" in c.form]
    return bool(dated) and all(clocks.order_is_open(c.moments, c.form) for c in dated)


def questions(columns, labels, traits, open_order):
    """What the file does not hold and a reader has to ask for, and what it may ask for without being wrong."""
    has = {c.quantity for c in columns}
    ask, may = [], []
    if traits["headings"] == "0":
        return ["headings"], ["height", "diameter", "cell pressure", "back pressure", "effective consolidation stress"]
    strain = "axial_strain" in has
    stress = bool(has & STRESSES)
    sized = "current_area" in has or "diameter_mm" in labels
    tall = "height_mm" in labels or "specimen_height" in has
    volume = bool(has & {"back_volume", "volume_change"}) and not has & {"volumetric_strain", "void_ratio"}
    drains = traits["kind"] in ("CID", "CSD", "consolidation", "stages")
    (ask if not tall and ("axial_displacement" in has and not strain or volume and drains and not strain) else may).append("height")
    (ask if not sized and ("axial_force" in has and not stress or volume and drains) else may).append("diameter")
    if traits["kind"] not in TOTAL_STRESS:
        cell = bool(has & TOTAL) or "cell_pressure_kPa" in labels
        pore = "pore_pressure" in has or "back_pressure" in has or "back_pressure_kPa" in labels
        known = bool(has & EFFECTIVE) or cell and pore or "effective_consolidation_stress_kPa" in labels
        if known:
            may += ["cell pressure", "back pressure", "effective consolidation stress"]
        elif cell:
            ask.append("back pressure")
            may.append("effective consolidation stress")
        elif pore:
            ask.append("cell pressure")
            may += ["effective consolidation stress", "back pressure"]
        else:
            ask.append("effective consolidation stress")
            may += ["cell pressure", "back pressure"]
    else:
        may += ["cell pressure"]
    if traits["definition"] == "t_s_named_q_p":
        ask.append("that these are s' and t")
    for column in columns:
        if column.unit_source == "asked":
            ask.append(f"unit of {column.title}")
        elif column.unit_source == "identity" and DIMENSION.get(column.quantity, "pressure") in ("pressure", "force", "length", "volume"):
            may.append(f"unit of {column.title}")
        if column.extra.get("sign_open"):
            may.append(f"sign of {column.title}")
        if open_order and column.quantity in ("clock", "date"):
            decided = "." in column.form or traits["decimal"] == "comma"  # by the usage of the language
            (may if decided else ask).append("order of day and month")
    return list(dict.fromkeys(ask)), [m for m in dict.fromkeys(may) if m not in ask]


def mark_open_signs(columns, traits):
    """A volume that does not change has no sign that the readings could decide."""
    if traits["kind"] in ("CID", "CSD", "consolidation", "stages"):
        return
    for column in columns:
        if column.quantity in VOLUMES:
            column.extra["sign_open"] = True
