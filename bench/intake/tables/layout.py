# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of a file: preamble, headings, readings, trailing lines; their separators, quotes and code page."""
from dataclasses import dataclass, field

from . import clocks
from .columns import Column
from .units import FACTOR

SEPARATOR = {"comma": ",", "semicolon": ";", "tab": "\t", "space": " "}
WORD = {"comma": "comma", "semicolon": "semicolon", "tab": "tab", "space": "blanks", "wide": "wide blanks", "sheet": "sheet"}
MARK = {"hash": "#", "slashes": "//", "semicolon": ";", "exclamation": "!", "stars": "**", "percent": "%"}
THOUSANDS = {"comma": ",", "point": ".", "nbsp": "\u00a0", "apostrophe": "'"}
TYPES = {"ICU": ["CU", "CIU", "CIUC", "CU+u"], "CID": ["CD", "CID", "CIDC"], "CSD": ["CSD"], "UU": ["UU"], "UC": ["UC", "UCS"],
         "cyclic": ["Cyclic CU"], "consolidation": ["Isotropic consolidation"]}
LABEL_UNIT = {"height": "length", "diameter": "length"}


@dataclass
class Line:
    cells: list
    role: str = "text"     # text, heading, units, statistics, blank, reading, summary
    test: int = 0
    row: int = -1          # reading of its test
    raw: bool = False      # one string, written as it is


@dataclass
class Labels:
    lines: list = field(default_factory=list)
    values: dict = field(default_factory=dict)  # canonical


def number(value, decimals, traits):
    text = f"{value:.{decimals}f}"
    return text.replace(".", ",") if traits["decimal"] == "comma" else text


def type_of(random, test, traits):
    if test.kind == "stages":
        return random.choice(["CD", "CID"] if test.drained else ["CU", "CIU"])
    if traits["direction"] == "extension":
        return "CIUE" if test.kind == "ICU" else "CIDE"
    return random.choice(TYPES[test.kind])


def label_items(random, plan, test, traits):
    """(name, value, unit written, key, canonical value) of the labels above the table."""
    items, units, names = [], plan.units, plan.names
    if traits["labels"] == "given":
        wanted = ["height", "diameter"] if traits["view"] in ("raw", "sheet") or random.random() < 0.6 else []
        if traits["cell_source"] == "label":
            wanted.append("cell_pressure")
        one_test = traits["blocks"] in ("one", "restart") and test.kind not in ("UU", "UC", "stages")
        if one_test and random.random() < 0.45:
            wanted.append("back_pressure")
        if one_test and traits["cell_source"] == "absent" and random.random() < 0.6:
            wanted.append("effective_consolidation_stress")
        for key in wanted:
            value = {"height": test.height, "diameter": test.diameter, "cell_pressure": test.cell, "back_pressure": test.back,
                     "effective_consolidation_stress": test.consolidation_stress}[key]
            unit = units.chosen["length" if key in LABEL_UNIT else "pressure"]
            if unit == "0.01 mm":
                unit = "mm"
            decimals = {"kPa": 1, "MPa": 3, "bar": 2, "kgf/cm2": 3, "psi": 2, "mm": 2, "cm": 3, "in": 4}[unit]
            text = f"{value / FACTOR[unit]:.{decimals}f}"
            suffix = "_mm" if key in LABEL_UNIT else "_kPa"
            shown = number(float(text), decimals, traits)
            items.append((names.label(key), shown, units.spelling(unit) if traits["unit_style"] != "none" else unit, key + suffix,
                          float(text) * FACTOR[unit]))
    if traits["type_said"] == "yes":
        items.append((names.label("type"), type_of(random, test, traits), "", "", None))
    items = [(name, value, "", "", None) for name, value in others(random, plan, traits, random.randint(0, 3))] + items
    return items


def others(random, plan, traits, count):
    """Names and values that no test needs: borehole, sample, client ..."""
    values = [random.choice(["BH-3", "12/4"]), "S-07", "Muster & Co", "2026-118", "A. Muster", number(random.uniform(1, 20), 1, traits)]
    return [(name, values[i]) for i, name in sorted(random.sample(list(enumerate(names_of(plan, "other"))), count))]


def names_of(plan, key):
    from .names import TABLE
    listed = TABLE["labels"][key]
    names = [plan.names.choose([n]) for n in listed[plan.names.language]]
    return [n for n in names if n] or listed["en"]


def preamble(random, plan, test, traits):
    kind, out = traits["preamble"], Labels()
    if kind == "none":
        return out
    if kind == "logger":
        text = f"Logger: {random.choice([4, 6, 8])}-ch,Serial {random.randint(100, 9999):04d},Firmware {random.choice(['2.1', '3.04'])}"
        out.lines.append(Line([text], raw=True))
        return out
    if kind == "text":
        title = random.choice(plan.names.words("title"))
        said = f" {type_of(random, test, traits)}" if traits["type_said"] == "yes" else ""
        out.lines.append(Line([title + said]))
        out.lines += [Line([f"{name}: {value}"]) for name, value in others(random, plan, traits, random.randint(0, 2))]
    else:
        items = label_items(random, plan, test, traits)
        out.values = {key: value for _, _, _, key, value in items if key}
        colon = random.choice(["", ":"])
        if kind == "text_labels":
            out.lines += [Line([f"{name}: {value} {unit}".strip()]) for name, value, unit, _, _ in items]
        elif kind == "pairs":
            apart = random.random() < 0.3
            for name, value, unit, _, _ in items:
                if unit and apart:
                    out.lines.append(Line([name + colon, value, unit]))
                else:
                    out.lines.append(Line([f"{name} ({unit})" + colon if unit else name + colon, value]))
        else:
            cells = []
            for name, value, unit, _, _ in items:
                cells += ([""] if cells else []) + [f"{name} ({unit})" if unit else name, value]
            half = 6 * ((len(items) + 3) // 4)
            out.lines += [Line(cells[i:i + half]) for i in range(0, len(cells), half)] if cells else []
    if out.lines and random.random() < 0.25 and traits["comment"] == "none":
        out.lines.append(Line([], "blank"))
    return out


def heading_rows(random, plan, columns, traits, titles):
    """Lines from the group names to the last line above the readings."""
    count, style = int(traits["headings"]), traits["unit_style"]
    if count == 0:
        return []
    names = Line([c.heading for c in columns], "heading")
    rows = [names]
    if plan.has_groups:
        cells, last = [], ""
        for column in columns:
            group = column.extra.get("group", "")
            cells.append(group if group != last else "")
            last = group
        rows.insert(0, Line(cells, "heading"))
    if style == "row":
        filler = "-" if traits["separator"] in ("space", "wide") else ""
        left, right = ("[", "]") if plan.bracket_row else ("", "")
        rows.append(Line([f"{left}{c.written}{right}" if c.written else filler for c in columns], "units"))
        if count == 3 and not plan.groups:
            rows.append(Line([random.choice(["Avg", "Smp"]) if c.is_number else "" for c in columns], "statistics"))
    if titles:
        rows.insert(0, titles)
    return rows


def summary(random, plan, columns, traits):
    lines = []
    if traits["trailing"] == "text":
        lines = [Line([text]) for text in random.sample(plan.names.words("ending"), 1)]
    elif traits["trailing"] == "summary":
        words = plan.names.words("summary")
        filler = "-" if traits["separator"] == "space" else ""
        for k in sorted(random.sample(range(4), random.randint(1, 3))):
            at = random.randrange(len(columns[0].cells))
            cells = []
            for c in columns:
                if not c.is_number or not c.plain:
                    cells.append(filler)
                elif k == 3:
                    cells.append(c.cells[at])
                else:
                    order = sorted(range(len(c.plain)), key=lambda i, c=c: float(c.plain[i]))
                    cells.append(c.cells[order[{0: -1, 1: 0, 2: len(order) // 2}[k]]])
            lines.append(Line([words[k].replace(" ", "_") if traits["separator"] == "space" else words[k]] + cells[1:], "summary"))
    if lines and random.random() < 0.6:
        lines.insert(0, Line([], "blank"))
    return lines


def with_extra_columns(random, plan, columns, traits):
    """Columns with what no instrument wrote: an index, a blank column, the names of the heading lines."""
    rows = len(columns[0].cells)
    extra = traits["extra_cells"]
    if extra == "index":
        index = Column("reading_number", cells=[str(i) for i in range(rows)], plain=[str(i) for i in range(rows)])
        return [index] + columns
    if extra == "blank_column":
        at = plan.blank_at % (len(columns) - 1) + 1
        return columns[:at] + [Column("blank", cells=[""] * rows)] + columns[at:]
    if extra == "row_names":
        name, unit = plan.names.words("row_names")
        return [Column("row name", name=name, heading=name, written=unit, cells=[""] * rows)] + columns
    return columns


def quoted(cell, separator, mode):
    if mode == "all" or separator in cell or '"' in cell or mode == "text" and not is_numeric(cell):
        return '"' + cell.replace('"', '""') + '"'
    return cell


def is_numeric(cell):
    return not cell or cell[0] in "0123456789+-.,−"


def marked(lines, random, traits):
    """Comment marks in front of the preamble, the headings, or both."""
    if traits["comment"] == "none":
        return
    mark = MARK[traits["comment"]] + random.choice([" ", " ", ""] if traits["separator"] != "space" else [" "])
    for line in lines:
        heading = line.role in ("heading", "units", "statistics")
        wanted = line.role == "text" and traits["commented"] != "heading" or heading and traits["commented"] in ("heading", "both")
        if wanted and line.cells and line.row < 0:
            line.cells[0] = mark + line.cells[0]


def text_of(lines, random, traits):
    """The file as one string per line."""
    mode, kind = traits["quoting"], traits["separator"]
    if kind == "wide":
        table = [line for line in lines if line.role in ("heading", "units", "statistics", "reading")]
        widths = [max(len(line.cells[i]) for line in table) for i in range(len(table[0].cells))]
        gap = " " * random.choice([2, 3, 4])
        left = random.random() < 0.25 and all(cell for line in table for cell in line.cells)
        out = []
        for line in lines:
            if line in table:
                out.append(gap.join(c.ljust(w) if left else c.rjust(w) for c, w in zip(line.cells, widths)).rstrip(" "))
            else:
                out.append("  ".join(line.cells))
        return out
    separator = SEPARATOR[kind]
    end = separator if traits["extra_cells"] == "trailing_separator" else ""
    out = []
    for line in lines:
        if line.raw or kind == "space" and line.role == "text":
            out.append(line.cells[0])
        elif not line.cells:
            out.append("")
        elif kind == "space":
            out.append(" ".join(line.cells))
        elif mode == "needed":
            out.append(separator.join([c if separator not in c and '"' not in c else quoted(c, separator, mode) for c in line.cells]) + end)
        else:
            out.append(separator.join([quoted(c, separator, mode) for c in line.cells]) + end)
    return out


def kind_of(test, traits, quantities):
    """The kind as the numbers, or a label, say it."""
    kind = test.kind
    if kind == "UU":
        return "UU, total stresses" if traits["type_said"] == "yes" else "not said"
    if kind == "UC":
        return "UC, total stresses" if traits["type_said"] == "yes" else "not said"
    drains = quantities & {"volumetric_strain", "back_volume", "volume_change", "void_ratio"}
    if kind == "CSD" and not drains and traits["type_said"] != "yes":
        return "not said"
    if kind == "stages":
        return "saturation, consolidation and " + ("drained" if test.drained else "undrained") + " shear"
    return {"ICU": "consolidated, undrained in shear", "CID": "drained compression", "CSD": "drained, constant shear",
            "cyclic": "cyclic, undrained", "consolidation": "consolidation only"}[kind].replace(
                "compression", "extension" if traits["direction"] == "extension" else "compression")


def clock_first(column, index):
    """The reading `index` of a clock as ISO text."""
    moment = column.moments[index]
    if column.quantity == "date":
        return moment.date().isoformat()
    if column.quantity == "time_of_day":
        if "%S" not in column.form:
            moment = moment.replace(second=0)
        return moment.time().isoformat()
    if "%S" not in column.form and "%" in column.form:
        moment = moment.replace(second=0)
    return moment.isoformat() + ("+00:00" if "%z" in column.form else "")


def clock_extra(column, traits):
    form = column.form
    extra = {"format": form}
    if "%b" in form:
        extra["month_names"] = traits["language"] if traits["language"] in clocks.MONTHS else "en"
    return extra
