# SPDX-License-Identifier: GPL-3.0-or-later
"""Columns of a file: which quantities, under which headings, in which units."""
from dataclasses import dataclass, field

from . import clocks
from .specimen import TOTAL_STRESS
from .units import DIMENSION, FACTOR

EFFECTIVE = {"effective_radial_stress", "effective_axial_stress", "mean_effective_stress", "mean_effective_stress_2d"}
TOTAL = {"cell_pressure", "radial_stress", "axial_stress", "mean_stress"}
STRESSES = {"deviator_stress", "half_deviator_stress", "axial_stress", "effective_axial_stress"}
TENSION_NEGATIVE = {"axial_strain", "radial_strain", "volumetric_strain", "axial_stress", "radial_stress", "effective_axial_stress",
                    "effective_radial_stress", "mean_stress", "mean_effective_stress"}
VOLUMES = {"back_volume", "volume_change", "volumetric_strain", "radial_strain"}
IN = {"en": "in", "de": "in", "fr": "en", "es": "en", "pt": "em", "it": "in"}
GROUP = {"time": 0, "length": 1, "strain": 1, "force": 2, "division": 2, "pressure": 4, "volume": 5, "area": 1, "ratio": 6, "count": 6,
         "temperature": 6}


@dataclass
class Column:
    quantity: str
    name: str = ""            # as written, without the unit
    heading: str = ""         # as written, with the unit if it is in the same cell
    unit: str = ""            # canonical
    written: str = ""         # unit as written
    unit_source: str = "name"
    factor: float = 1.0
    sign: int = 1
    decimals: int = 0
    plain: list = field(default_factory=list)   # cells as plain numbers
    cells: list = field(default_factory=list)   # cells as written
    moments: list = field(default_factory=list)  # of clocks
    extra: dict = field(default_factory=dict)   # further keys of the expected column
    form: str = ""            # of clocks
    unpadded: bool = False
    test: int = 0

    @property
    def title(self):
        """The whole heading without the unit, with the name of its group."""
        return (self.extra.get("group", "") + " " + self.name).strip()

    @property
    def is_number(self):
        return bool(self.plain) and not self.form


def stress_quantities(random, traits):
    """Quantities of the view that are stresses, in the order of the table."""
    kind, pore = traits["kind"], traits["pore"]
    pores = {"total": ["pore_pressure"], "none": []}.get(pore, ["excess_pore_pressure"])
    q = "deviator_stress" if traits["definition"] == "q_p" else "half_deviator_stress"
    p = "mean_effective_stress" if traits["definition"] == "q_p" else "mean_effective_stress_2d"
    cell = ["cell_pressure"] if traits["cell_source"] == "column" else []
    if kind in TOTAL_STRESS:
        return ["axial_stress", "radial_stress"] if traits["view"] == "principal" else [q] + cell
    if kind == "consolidation":
        return ["cell_pressure"] + pores + random.choice([[], ["effective_radial_stress"], ["mean_effective_stress"]])
    if traits["view"] == "path":
        return [q, p] + (pores if traits["definition"] == "t_s_named_q_p" or random.random() < 0.6 else [])
    if traits["view"] == "principal":
        total, effective = ["axial_stress", "radial_stress"], ["effective_axial_stress", "effective_radial_stress"]
        chosen = {"total": total, "both": total + effective}.get(traits["stresses"], effective)
        if traits["stresses"] != "bare_effective" and random.random() < 0.4:
            chosen = chosen + ["deviator_stress"]
        return chosen + (pores or []) + (cell if traits["stresses"] == "bare_effective" else [])
    chosen = [q] + pores
    if traits["view"] == "sheet":
        chosen += random.choice([["effective_axial_stress", "effective_radial_stress", "mean_effective_stress"], [p], cell,
                                 ["effective_radial_stress", p, "stress_ratio"],
                                 ["mean_effective_stress_2d", "half_deviator_stress"],
                                 ["mean_stress", "mean_effective_stress"] if pore == "total" else [p]])
    elif traits["definition"] == "t_s_named_q_p":
        chosen += [p]
    else:
        chosen += random.choice([[p], [p], ["effective_radial_stress"], ["effective_axial_stress", "effective_radial_stress", p],
                                 cell if pore == "total" else [p], [p, "stress_ratio"] if q == "deviator_stress" else [p],
                                 ["effective_axial_stress", "effective_radial_stress", "principal_stress_ratio"]])
    if pore == "none" and not set(chosen) & EFFECTIVE:
        chosen.append(p)
    return chosen


def quantities(random, traits):
    """All measured or reduced quantities of the file, without clocks."""
    kind, view = traits["kind"], traits["view"]
    drains = kind in ("CID", "CSD", "consolidation", "stages")
    if view == "raw":
        chosen = [] if kind == "consolidation" and random.random() < 0.4 else ["axial_displacement"]
        chosen += [] if kind == "consolidation" else ["axial_force"]
        chosen += ["cell_pressure"] if traits["cell_source"] == "column" else []
        if kind not in TOTAL_STRESS:
            chosen += ["back_pressure"] if random.random() < 0.35 and kind in ("CID", "consolidation", "ICU", "cyclic") else []
            chosen += [{"total": "pore_pressure"}.get(traits["pore"], "excess_pore_pressure")] if traits["pore"] != "none" else []
            if drains or random.random() < 0.15:
                chosen.append(random.choice(["back_volume", "volume_change", "volume_change"]))
            chosen += ["cell_volume"] if random.random() < 0.08 else []
    else:
        chosen = ["volumetric_strain"] if kind == "consolidation" else ["axial_strain"]
        if kind == "consolidation" and random.random() < 0.5:
            chosen.append("void_ratio")
        elif drains and kind != "consolidation" and random.random() < 0.85:
            chosen.append("volumetric_strain")
            if random.random() < 0.2:
                chosen.append("radial_strain")
            if random.random() < 0.2:
                chosen.append("void_ratio")
        if view == "sheet":
            chosen = ["axial_displacement", "axial_force"] + chosen + (["current_area"] if random.random() < 0.7 else [])
            if random.random() < 0.15 and kind in TOTAL_STRESS:
                chosen.insert(1, "force_reading")
        chosen += stress_quantities(random, traits)
        if random.random() < 0.08 and traits["unit_style"] not in ("none", "partial"):
            chosen.append("specimen_height")
    if kind == "cyclic" and random.random() < 0.7:
        chosen.insert(0, "cycle")
    chosen = list(dict.fromkeys(chosen))
    if traits["headings"] != "0":
        if random.random() < 0.07 and traits["unit_style"] not in ("none", "partial"):
            chosen.append("temperature")
        if random.random() < 0.06 and "cell_pressure" in chosen and kind in ("ICU", "CID", "CSD", "UU"):
            chosen.append("ignored")
        if random.random() < 0.06 and traits["separator"] not in ("space", "wide"):
            chosen.append("text")
    if random.random() < 0.2 and chosen[0] == "axial_strain":  # stresses first
        chosen = chosen[1:] + chosen[:1]
    return chosen


def named_as(quantity, traits):
    """The quantity whose names are used for the heading, and whether only its symbols are."""
    if traits["definition"] == "t_s_named_q_p":
        other = {"half_deviator_stress": "deviator_stress", "mean_effective_stress_2d": "mean_effective_stress"}.get(quantity)
        if other:
            return other, True
    if traits["stresses"] == "bare_effective":
        other = {"effective_axial_stress": "axial_stress", "effective_radial_stress": "radial_stress"}.get(quantity)
        if other:
            return other, True
    if quantity == "excess_pore_pressure" and traits["pore"] == "excess_named_pore":
        return "pore_pressure", False
    if quantity == "deviator_stress" and traits["kind"] == "UC":
        return "compressive_stress", False
    return quantity, False


def sign_of(quantity, traits):
    if traits["axial_sign"] == "displacement_negative" and quantity == "axial_displacement":
        return -1
    if traits["axial_sign"] == "tension_positive" and quantity in TENSION_NEGATIVE:
        return -1
    return -1 if traits["volume_sign"] == "reversed" and quantity in VOLUMES - {"radial_strain"} else 1


def decorate(random, name, traits, position):
    style = traits["decoration"]
    words = len(name) > 3 and name.isascii() and not any(c in name for c in "'()/")
    if style == "upper" and words:
        return name.upper()
    if style == "lower" and words:
        return name.lower()
    if style == "channel":
        return f"Ch{position} {name}"
    if style == "statistic":
        return f"{name}_Avg"
    return name


def with_unit(name, unit, traits, tight):
    """Name and unit in one cell, in the style of the file."""
    style = traits["unit_style"]
    if style == "underscore":
        return f"{name.replace(' ', '_')}_{unit}" if unit else name.replace(" ", "_")
    if traits["decoration"] == "padded":
        return f"{name.replace(' ', '_').ljust(5, '_')}({unit})" if unit else name.replace(" ", "_").ljust(5, "_")
    if not unit or style in ("row", "none"):
        return name
    if style == "comma":
        return f"{name}, {unit}"
    if style == "slash":
        return f"{name}/{unit}" if tight else f"{name} / {unit}"
    if style == "in" and traits["language"] in IN:
        return f"{name} {IN[traits['language']]} {unit}"
    if style == "blank":
        return f"{name} {unit}"
    left, right = "[]" if style == "square" else "()"
    return f"{name}{'' if tight else ' '}{left}{unit}{right}"


def group_of(column):
    if column.form or column.quantity in ("time", "stage_time", "stage", "reading_number", "cycle"):
        return 0
    if column.quantity in ("cell_pressure", "back_pressure", "pore_pressure", "excess_pore_pressure"):
        return 3
    if column.quantity in ("text", "ignored"):
        return 6
    return GROUP[DIMENSION.get(column.quantity, "pressure")]


class Plan:
    """The columns of one file, drawn once and filled with the readings of each test in it."""

    def __init__(self, random, traits, names, units):
        self.random, self.traits, self.names, self.units = random, traits, names, units
        self.tight = random.random() < 0.3
        self.groups = random.random() < 0.6              # of three heading lines: group names, or how each value was taken
        self.has_groups = traits["headings"] == "2" and traits["unit_style"] != "row" or traits["headings"] == "3" and self.groups
        self.bracket_row = random.random() < 0.25        # [kPa] in the line of units
        self.blank_at = random.randrange(100)
        self.unit_of_fraction = random.random() < 0.5   # a plain strain has "mm/mm" or nothing
        chosen = quantities(random, traits)
        pressures = [q for q in chosen if DIMENSION.get(q, "pressure") == "pressure" and q not in ("text", "ignored")]
        self.with_unit = random.choice(pressures) if pressures else ""  # of unit_style=partial
        self.columns = self.clock_columns() + [self.column(q) for q in chosen]
        if self.has_groups:
            self.columns.sort(key=group_of)
            words = names.words("groups")
            for column in self.columns:
                column.extra["group"] = words[group_of(column)]
        for column in self.columns:
            if traits["separator"] == "space":
                column.heading = column.heading.replace(" ", "_")
        self.step = 60 if any("%S" not in c.form and "%M" in c.form for c in self.columns) else 1

    def column(self, quantity, **fixed):
        traits, style = self.traits, self.traits["unit_style"]
        dimension = DIMENSION.get(quantity, "pressure")
        column = Column(quantity)
        column.unit = fixed.get("unit") or ("" if quantity == "text" else self.units.unit(quantity))
        column.factor = FACTOR.get(column.unit, 1.0)
        column.sign = sign_of(quantity, traits)
        column.decimals = 0 if quantity == "text" else self.units.decimals(column.unit, quantity)
        has_unit = quantity != "text" and style != "none" and dimension != "count"
        if style == "partial" and dimension == "pressure" and quantity != self.with_unit:
            has_unit = False
        if column.unit == "" and has_unit:  # plain numbers
            small = dimension == "strain" and traits["kind"] in ("cyclic", "consolidation")  # the range does not tell % from a number
            possible = style != "partial" and (dimension == "strain" or style in ("round", "square", "row"))
            has_unit = possible and (small or self.unit_of_fraction)
        key, only_symbol = named_as(quantity, traits)
        column.name = self.names.column(key, has_unit and column.unit != "" or dimension == "count", only_symbol)
        column.written = self.units.spelling(column.unit) if has_unit else ""
        if dimension == "ratio" and has_unit:
            column.written = "-" if style in ("row", "round", "square") else ""
        if dimension == "count":
            column.unit_source = "name"
        elif column.written:
            column.unit_source = "units row" if style == "row" else "heading"
        else:
            column.unit_source = "none" if dimension == "ratio" else "identity"
        if traits["headings"] == "0":
            column.name = column.written = ""
            column.unit_source = "asked"
        else:
            column.name = decorate(self.random, column.name, traits, len(self.names.used))
        column.heading = with_unit(column.name, column.written, traits, self.tight)
        return column

    def clock_column(self, quantity, form):
        column = Column(quantity, form=form, unit_source="format")
        column.name = self.names.column(quantity)
        column.heading = column.name.replace(" ", "_") if self.traits["unit_style"] == "underscore" else column.name
        return column

    def clock_columns(self):
        """Columns of clocks, stages and numbers in front of the readings."""
        random, kind = self.random, self.traits["clock"]
        columns = []
        if kind.startswith("elapsed"):
            columns = [self.column("time", unit={"s": "s", "min": "min", "h": "h"}[kind.split("_")[1]])]
        elif kind in ("hms",):
            columns = [self.clock_column("time", "h:mm:ss")]
        elif kind in ("excel_serial", "unix_ms", "unix_s"):
            columns = [self.clock_column("clock", kind.replace("_", " "))]
        elif kind in ("date_and_time", "date_on_change"):
            english = self.traits["language"] == "en"
            date = random.choice([f for f in clocks.DATES if english or f != "%m/%d/%Y"])
            half_day = ["%I:%M:%S %p"] if english and self.traits["separator"] != "space" else []
            hour = random.choice(["%H:%M:%S", "%H:%M:%S", "%H:%M"] + half_day)
            columns = [self.clock_column("date", date), self.clock_column("time_of_day", hour)]
        elif kind == "time_of_day":
            columns = [self.clock_column("time_of_day", random.choice(["%H:%M:%S", "%H:%M"]))]
        elif kind in ("stage_only", "stage_and_total"):
            unit = random.choice(["s", "min"])
            columns = [self.column("time", unit=unit)] if kind == "stage_and_total" else []
            columns += [self.column("stage_time", unit=unit)]
            random.shuffle(columns)
        elif kind != "none":
            columns = [self.clock_column("clock", random.choice(clocks.FORMATS[kind]))]
            if self.traits["clock_cells"] == "typed":
                columns[0].form = "xlsx date"
            if kind == "iso_and_elapsed":
                columns.append(self.column("time", unit=random.choice(["s", "min"])))
                if self.traits["unit_style"] == "none":
                    columns[1].extra["check"] = "the clock beside it says the unit"
        for column in columns:
            column.unpadded = kind in clocks.UNPADDED and random.random() < 0.6
            if column.quantity == "time" and not column.written and not column.form and kind != "iso_and_elapsed":
                column.unit_source = "asked"
                column.extra["candidates"] = ["s", "min", "h"]
        if self.traits["kind"] == "stages":
            columns.insert(random.choice([0, len(columns)]), self.column("stage"))
        if random.random() < 0.08 and self.traits["headings"] != "0":
            columns.insert(0, self.column("reading_number"))
        return columns
