#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_tables.py --seed N --count M --out FOLDER [--trait KEY=VALUE]... [--names FILE] [--invented SHARE] [--list-traits]

Writes M table files of triaxial tests, as laboratories and loggers write them, and for each of them NAME.expected.toml with the meaning
that a reader should find. Its keys:
  encoding, separator, decimal, thousands, quoted, comment, sheet    of the file
  heading_lines, unit_line (0: none), data_lines, repeated_heading_lines    line numbers from 1; in a workbook rows
  first_complete_line    the reading with all values, which are `first` of the columns; `last` is of the last of data_lines
  missing     cells [line, column] without a value, which may hold a fill value
  row_order   "reversed" if the last reading comes first
  tests, test_lines    number of tests, if more than one, and the first and last line of each; side by side: `test` of each column
  kind        what the numbers, or a label, say about the test; "not said"
  ask         what the file does not contain and a reader has to ask for
  may_ask     what a reader may ask for, although the file decides it or no result depends on it
  elapsed_s   from the first complete reading to the last
  [labels]    values above the table, in mm and kPa
  [traits]    how the file was made
  [[identities]]    what is true for all readings, and within which residual
  [[columns]] position, heading, quantity, unit, written (the unit as written), unit_source, factor and sign to canonical units, first, last
              unit_source: heading, units row, name, format, identity (physics decides), none (a ratio), asked (the file does not decide)
              sign_open: a volume that does not change has no sign; last_line: the last reading of a shorter test beside another
Canonical units are s, mm, mm2, mm3, kN, kPa, degC and plain numbers. Compression, contraction, pressure and water into the specimen
(back_volume) are positive; volume_change is the decrease of the specimen.
--names takes names of columns from FILE, --invented gives a share of the columns names that say nothing: for development.
--trait fixes a trait (repeatable), for example --trait language=zh --trait fill=1e30. --list-traits prints traits and values.
The same seed gives the same files. Seeds below 1000 are for development. Published results use seeds from 1000 on, whose files also have
headings that are held back from the others (~ in tables/headings.toml).
"""
import argparse
import datetime
import pathlib
import random as randomness
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from tables import cells, clocks, columns as columns_of, expected, faults, layout, questions, specimen, traits as traits_of  # noqa: E402
from tables.layout import Line  # noqa: E402
from tables.names import FIRST_PUBLISHED_SEED, Names, replace_names  # noqa: E402
from tables.units import Units  # noqa: E402
from tables.workbook import Date, letters, workbook  # noqa: E402

ENDING = {"comma": [".csv"], "semicolon": [".csv", ".csv", ".txt"], "tab": [".txt", ".dat", ".asc"], "space": [".dat", ".txt"],
          "wide": [".txt", ".out", ".prn"], "sheet": [".xlsx"]}
NEWLINE = {"lf": "\n", "crlf": "\r\n", "cr": "\r"}
NO_UNIT = ("text", "ignored")


def row_count(random, traits):
    low, high = {"short": (10, 18), "medium": (20, 60), "long": (120, 240)}[traits["length"]]
    if traits["kind"] in ("stages", "cyclic"):
        low = max(low, 48)
        high = max(high, 90)
    return random.randint(low, high)


def simulated(random, plan, traits):
    """One test, or two of the same specimen size at different pressures."""
    tests = []
    for _ in range(2 if traits["blocks"] in ("beside", "below", "below_without_headings") else 1):
        rows = row_count(random, traits)
        if tests and traits["blocks"] == "beside":
            rows = len(tests[0].series["time"]) - (random.randint(1, 4) if random.random() < 0.4 else 0)
        size = (tests[0].diameter, tests[0].height) if tests else None
        tests.append(specimen.simulate(random, traits["kind"], rows, extension=traits["direction"] == "extension",
                                       noise=traits["noise"] == "yes", step=plan.step, size=size))
    return tests


def readings(columns, test, rows=None):
    count = len(columns[0].cells)
    return [Line([c.cells[i] for c in columns], "reading", test, i) for i in (rows or range(count))]


def body(random, plan, tests, traits):
    """Heading rows, readings and trailing lines, with the columns of each test as they are side by side in the file."""
    def heads(columns, titles=None):
        return layout.heading_rows(random, plan, columns, traits, titles)

    kind = traits["blocks"]
    if kind == "beside":
        left, right = tests
        blank = [columns_of.Column("blank", cells=[""] * len(left[0].cells))]
        short = len(left[0].cells) - len(right[0].cells)
        word = plan.names.words("specimen")[0]
        titles = None
        if random.random() < 0.7:
            titles = Line([f"{word} 1"] + [""] * len(left) + [f"{word} 2"] + [""] * (len(right) - 1), "heading")
        padded = [columns_of.Column(c.quantity, cells=c.cells + [""] * short, plain=c.plain) for c in right]
        lines = heads(left + blank + right, titles) + readings(left + blank + padded, 1)
        return lines, left + blank + right
    lines = heads(tests[0])
    count = len(tests[0][0].cells)
    if kind == "restart":
        cut = random.randrange(count // 3, count - 4)
        lines += readings(tests[0], 1, range(cut)) + heads(tests[0]) + readings(tests[0], 1, range(cut, count))
    else:
        lines += readings(tests[0], 1)
    if kind.startswith("below"):
        lines += [Line([], "blank")] if kind == "below" and random.random() < 0.5 else []
        lines += (heads(tests[1]) if kind == "below" else []) + readings(tests[1], 2)
    return lines + layout.summary(random, plan, tests[0], traits), tests[0]


def described(column, traits, first_row, last_column, last_row, last_line):
    """The keys of one expected column."""
    out = {"heading": column.title, "quantity": column.quantity}
    if column.quantity in ("blank", "row name"):
        why = "a blank column" if column.quantity == "blank" else "the first cell of each heading line names the line"
        return out | {"quantity": "ignored", "why": why}
    if column.test:
        out["test"] = column.test
    if column.quantity in NO_UNIT:
        return out
    if column.quantity in ("clock", "date", "time_of_day"):
        return out | layout.clock_extra(column, traits) | {"first": layout.clock_first(column, first_row),
                                                           "last": layout.clock_first(last_column, last_row)}
    if column.form == "words":
        return out | {"unit": "", "unit_source": column.unit_source, "first": column.cells[first_row], "last": last_column.cells[last_row]}
    unit = "h:mm:ss" if column.form else column.unit
    out |= {"unit": unit, "unit_source": column.unit_source}
    if column.written and column.written != column.unit:
        out["written"] = column.written
    first, last = float(column.plain[first_row]), float(last_column.plain[last_row])
    scale = column.factor * column.sign
    if column.unit_source == "asked":
        out |= {"first_as_written": first, "last_as_written": last, "true_factor": column.factor, "true_sign": column.sign}
    else:
        out |= {"factor": column.factor, "sign": column.sign, "first": first * scale + 0.0, "last": last * scale + 0.0}
    if last_line:
        out["last_line"] = last_line
    return out | {k: v for k, v in column.extra.items() if k not in ("group",)}


def as_cells(lines, traits, columns):
    """Rows of a worksheet: numbers where the text file would have plain numbers."""
    rows = []
    for line in lines:
        row = []
        for i, cell in enumerate(line.cells):
            column = columns[i] if line.role == "reading" else None
            if isinstance(cell, float):
                row.append(Date(cell))
            elif traits["decimal"] == "comma" or column is not None and not column.plain or line.role in ("heading", "units", "statistics"):
                row.append(cell)
            else:
                try:
                    row.append(float(cell) if "." in cell or "E" in cell else int(cell))
                except ValueError:
                    row.append(cell)
        rows.append([cell if not (isinstance(cell, float) and cell != cell) else "NaN" for cell in row])
    return rows


def merged_ranges(lines):
    """The cells that a group name spans, in the first heading line."""
    out = []
    for number, line in enumerate(lines, 1):
        below = lines[number] if number < len(lines) else None
        if line.role == "heading" and below is not None and below.role == "heading":
            filled = [i for i, c in enumerate(line.cells) if c] + [len(line.cells)]
            out += [f"{letters(a)}{number}:{letters(b - 1)}{number}" for a, b in zip(filled, filled[1:]) if b - a > 1]
    return out


def content(random, plan, lines, traits, columns, labels):
    """Bytes of the file, and of a workbook the name of its sheet."""
    if traits["container"] == "xlsx":
        cover, *names = plan.names.words("sheets")
        sheet = random.choice(names)
        data = (sheet, as_cells(lines, traits, columns))
        front = [(cover, as_cells(labels.lines, traits, columns) + [[], ["2026"]])] if traits["cover"] != "none" else []
        return workbook(front + [data], merged_ranges(lines)), sheet
    newline = NEWLINE[traits["newline"]]
    text = newline.join(layout.text_of(lines, random, traits)) + (newline if random.random() < 0.9 else "")
    codec = traits["encoding"]
    if text.isascii() and codec not in ("utf-8-sig", "utf-16"):
        traits["encoding"] = "ascii"
    return text.encode(codec), ""


def effective_traits(traits, tests, names):
    """Corrects traits that did not come into effect."""
    written = [cell for columns in tests for c in columns if c.is_number for cell in c.cells]
    columns = tests[0]
    mark = layout.THOUSANDS.get(traits["thousands"])
    quantities = {c.quantity for c in columns}
    if mark and not any(mark in cell for cell in written):
        traits["thousands"] = "none"
    if traits["numbers"] == "unicode_minus" and not any("−" in cell for cell in written):
        traits["numbers"] = "plain"
    if not quantities & {"axial_strain", "volumetric_strain", "radial_strain"}:
        traits["strain_unit"] = "none"
    if not quantities & columns_of.VOLUMES or any(c.extra.get("sign_open") for c in columns):
        traits["volume_sign"] = "none"
    if traits["axial_sign"] == "displacement_negative" and "axial_displacement" not in quantities:
        traits["axial_sign"] = "compression"
    traits["names"] = "held_back" if names.held_back_count else "listed"


def head_of(name, lines, traits, missing, test, quantities, asks, sheet, tests, start_line):
    """The keys of the file, and the line number of each reading."""
    numbers = {(line.test, line.row): n for n, line in enumerate(lines, 1) if line.role == "reading"}
    data = [n for n, line in enumerate(lines, 1) if line.role == "reading"]

    def of_role(role):
        return [n for n, line in enumerate(lines, 1) if line.role == role]

    headings, units = of_role("heading"), of_role("units")
    repeated = sorted(n for n in headings + units + of_role("statistics") if n > data[0])
    head = {"file": name, "encoding": "utf-8" if traits["encoding"] == "ascii" else traits["encoding"],
            "separator": layout.WORD[traits["separator"]], "decimal": "," if traits["decimal"] == "comma" else "."}
    if sheet:
        head["sheet"] = sheet
    if traits["thousands"] != "none":
        head["thousands"] = layout.THOUSANDS[traits["thousands"]]
    if traits["quoting"] in ("text", "all"):
        head["quoted"] = True
    if traits["comment"] != "none":
        head["comment"] = layout.MARK[traits["comment"]]
    head |= {"heading_lines": [n for n in headings if n < data[0]], "unit_line": min(units, default=0), "data_lines": data}
    if repeated:
        head["repeated_heading_lines"] = repeated
    head["first_complete_line"] = start_line
    if missing:
        head["missing"] = sorted(missing)
    if traits["order"] == "reversed":
        head["row_order"] = "reversed"
    if len(tests) > 1:
        head["tests"] = len(tests)
        if traits["blocks"] != "beside":
            head["test_lines"] = [[min(n for (t, _), n in numbers.items() if t == k), max(n for (t, _), n in numbers.items() if t == k)]
                                  for k in (1, 2)]
    kind = layout.kind_of(test, traits, quantities)
    head["kind"] = ("two tests, " if len(tests) > 1 and kind != "not said" else "") + kind
    head["ask"], head["may_ask"] = asks
    return head


def make_file(seed, index, forced, name=None, invented=0.0):
    """(file name, bytes, expected TOML) of the file `index` of a seed. It does not depend on the number of files."""
    random = randomness.Random(f"triax intake {seed} {index}")
    traits = traits_of.draw(random, forced)
    names = Names(random, traits, held_back=seed >= FIRST_PUBLISHED_SEED, invented=invented)
    plan = columns_of.Plan(random, traits, names, Units(random, traits, names.codec))
    tests = simulated(random, plan, traits)
    begin, filled = None, []
    for number, test in enumerate(tests, 1):
        times = test.series["time"]
        begin = clocks.start(random, times, traits["clock"] == "midnight_bare") if begin is None else \
            begin + datetime.timedelta(seconds=tests[0].series["time"][-1] + random.randint(3600, 80000) // 60 * 60)
        filled.append(cells.filled(plan, random, test, begin, number if traits["blocks"] == "beside" else 0))
        questions.mark_open_signs(filled[-1], traits)
    holes = faults.fill(random, filled[0], traits)
    if traits["order"] == "reversed":
        faults.reverse(filled[0])
        rows = len(filled[0][0].cells)
        holes = {(rows - 1 - row, at) for row, at in holes}
        if any(row == rows - 1 for row, _ in holes):  # the last reading in the file is complete
            for row, at in [hole for hole in holes if hole[0] == rows - 1]:
                filled[0][at].cells[row] = cells.display([filled[0][at].plain[row]], traits)[0]
                holes.discard((row, at))
    labels = layout.preamble(random, plan, tests[0], traits)
    asks = questions.questions(filled[0], labels.values, traits, questions.order_is_open(filled))
    offset_of = {id(c): i for i, c in enumerate(filled[0])}
    if traits["blocks"] != "beside":
        filled = [layout.with_extra_columns(random, plan, columns, traits) for columns in filled]
    lines, columns = body(random, plan, filled, traits)
    blank = [Line([], "blank")] if traits["headings"] != "0" and random.random() < 0.06 and traits["container"] == "text" else []
    first_reading = next(i for i, line in enumerate(lines) if line.role == "reading")
    above = labels.lines if traits["cover"] != "only" else []
    lines = above + lines[:first_reading] + blank + lines[first_reading:]
    layout.marked(lines, random, traits)
    position = {offset_of[id(c)]: i for i, c in enumerate(columns) if id(c) in offset_of}
    line_of = {line.row: n for n, line in enumerate(lines, 1) if line.role == "reading" and line.test == 1}
    missing = {(line_of[row], position[at] + 1) for row, at in holes}
    first_row = next(row for row in range(len(line_of)) if not any(hole[0] == row for hole in holes))
    effective_traits(traits, filled, names)
    traits["date_order"] = "open" if "order of day and month" in asks[0] else "decided" if any(c.moments for c in columns) else "none"
    data, sheet = content(random, plan, lines, traits, columns, labels)
    name = name or f"t{seed}_{index:05d}"
    name += random.choice(ENDING[traits["separator"]])
    head = head_of(name, lines, traits, missing, tests[0], {c.quantity for c in columns}, asks, sheet, tests, line_of[first_row])
    if len(tests) == 1 and any(c.quantity in ("time", "clock", "time_of_day") for c in columns):
        times = tests[0].series["time"]
        head["elapsed_s"] = float(abs(times[-1] - times[first_row]) if traits["order"] == "ascending" else times[-1 - first_row])
    out, below = [], traits["blocks"].startswith("below")
    for i, column in enumerate(columns):
        last_column = filled[1][i] if below else column
        last_row = len(last_column.cells) - 1
        last_line = 0
        if traits["blocks"] == "beside" and column.test == 2 and last_row + 1 < len(line_of):
            last_line = line_of[last_row]
        is_beside = traits["blocks"] == "beside" and column.test == 2  # without missing values
        document = described(column, traits, 0 if is_beside else first_row, last_column, last_row, last_line)
        if is_beside and first_row > 0 and "quantity" in document:
            document["first_line"] = line_of[0]
        out.append((column, document))
    return name, data, expected.document(head, labels.values, out, {"seed": seed, **traits})


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1, help="below 1000: development; from 1000 on: published [1]")
    parser.add_argument("--count", type=int, default=100, help="number of files [100]")
    parser.add_argument("--out", type=pathlib.Path, help="folder for the files")
    parser.add_argument("--trait", action="append", default=[], metavar="KEY=VALUE", help="fix a trait (repeatable)")
    parser.add_argument("--invented", type=float, default=0.0, metavar="SHARE", help="share of columns whose name says nothing [0]")
    parser.add_argument("--names", type=pathlib.Path, metavar="FILE",
                        help="names of columns instead of the listed ones: lines of quantity, language and name, with tabs between them")
    parser.add_argument("--list-traits", action="store_true", help="print the traits with their values and exit")
    return parser


def list_traits():
    values = {name: {} for name in traits_of.NAMES}
    random = randomness.Random(1)
    for _ in range(20000):
        for name, value in traits_of.draw(random, {}).items():
            values[name][value] = values[name].get(value, 0) + 1
    for name, counts in values.items():
        print(name + ": " + ", ".join(f"{value} {100 * n / 20000:.1f} %" for value, n in sorted(counts.items(), key=lambda x: -x[1])))


def main():
    parser = arguments()
    options = parser.parse_args()
    if options.list_traits:
        return list_traits()
    if not options.out:
        parser.error("missing --out FOLDER")
    forced = dict(item.partition("=")[::2] for item in options.trait)
    unknown = set(forced) - set(traits_of.NAMES)
    if unknown:
        parser.error(f"unknown trait {', '.join(sorted(unknown))}; must be one of: {', '.join(traits_of.NAMES)}")
    if options.names:
        replace_names(options.names)
    options.out.mkdir(parents=True, exist_ok=True)
    for index in range(options.count):
        try:
            name, data, toml = make_file(options.seed, index, forced, invented=options.invented)
        except ValueError as error:
            if "no file has these traits" not in str(error):
                raise
            parser.error(str(error))
        (options.out / name).write_bytes(data)
        (options.out / name).with_suffix(".expected.toml").write_text(toml, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
