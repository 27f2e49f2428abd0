#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_tables.py FOLDER: checks the files of make_tables.py against their expected.toml with a reader of its own.

Every cell is read as the expected file says; then first and last values, elapsed time, missing cells, units, and the identities between
columns (q = F/A, p' = σ3' + q/3, σ3 = σ3' + u, εv = ε1 + 2 εr and so on) must hold within the rounding of the cells. Prints each fault,
the number of files, cells and identities, and the largest residual in units of the rounding. Exit status 1 if there is a fault.
"""
import csv
import datetime
import math
import pathlib
import re
import sys
import tomllib
import xml.etree.ElementTree as ElementTree
import zipfile

SEPARATOR = {"tab": "\t", "comma": ",", "semicolon": ";"}
FACTOR = {"s": 1, "min": 60, "h": 3600, "mm": 1, "cm": 10, "in": 25.4, "0.01 mm": 0.01, "kN": 1, "N": 1e-3, "kgf": 9.80665e-3,
          "lbf": 4.4482216152605e-3, "kPa": 1, "MPa": 1e3, "bar": 100, "kgf/cm2": 98.0665, "psi": 6.894757293168,
          "mm3": 1, "cm3": 1e3, "ml": 1e3,
          "in3": 25.4**3, "mm2": 1, "cm2": 100, "in2": 25.4**2, "%": 0.01, "": 1, "per mille": 1e-3, "degC": 1, "div": 1, "h:mm:ss": 1}
MONTHS = {"en": "jan feb mar apr may jun jul aug sep oct nov dec", "de": "jan feb mär apr mai jun jul aug sep okt nov dez",
          "fr": "janv févr mars avr mai juin juil août sept oct nov déc", "es": "ene feb mar abr may jun jul ago sep oct nov dic",
          "pt": "jan fev mar abr mai jun jul ago set out nov dez", "it": "gen feb mar apr mag giu lug ago set ott nov dic"}
FILLS = {"", "-", "--", "---", "n/a", "nan", "ovrflo", "overload", "ol", "#div/0!", "#n/a"}
MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
EXCEL = datetime.datetime(1899, 12, 30)


def sheet_rows(path, name):
    """Cells of a worksheet as text, dates as datetimes."""
    with zipfile.ZipFile(path) as book:
        sheets = [s.get("name") for s in ElementTree.fromstring(book.read("xl/workbook.xml")).iter(MAIN + "sheet")]
        root = ElementTree.fromstring(book.read(f"xl/worksheets/sheet{sheets.index(name) + 1}.xml"))
    rows = {}
    for cell in root.iter(MAIN + "c"):
        letters, number = re.fullmatch(r"([A-Z]+)(\d+)", cell.get("r")).groups()
        column = 0
        for c in letters:
            column = column * 26 + ord(c) - 64
        text = "".join(t.text or "" for t in cell.iter(MAIN + "t")) if cell.get("t") == "inlineStr" else cell.find(MAIN + "v").text
        if cell.get("s") == "1":
            text = EXCEL + datetime.timedelta(seconds=round(float(text) * 86400))
        rows.setdefault(int(number), {})[column] = text
    last = max(rows)
    return [[rows.get(r, {}).get(c, "") for c in range(1, max(rows.get(r, {0: 0})) + 1)] for r in range(1, last + 1)]


def wide_rows(lines, wanted):
    """Cells of aligned lines: a column ends where all of them have two blanks."""
    table = [lines[n - 1] for n in wanted]
    width = max(map(len, table))
    used = [any(len(line) > i and line[i] != " " for line in table) for i in range(width)]
    spans, begin, blanks = [], None, 0
    for i, u in enumerate(used + [False, False]):
        if u:
            begin, blanks = i if begin is None else begin, 0
        elif begin is not None:
            blanks += 1
            if blanks == 2:
                spans.append((begin, i - 1))
                begin = None
    return [[line[a:b].strip() for a, b in spans] if n in wanted else [line] for n, line in enumerate(lines, 1)]


def rows_of(path, e):
    if e["separator"] == "sheet":
        return sheet_rows(path, e["sheet"])
    text = path.read_bytes().decode(e["encoding"])
    lines = re.split(r"\r\n|\n|\r", text)
    lines = lines[:-1] if lines[-1] == "" else lines
    table = e["heading_lines"] + [n for n in [e["unit_line"]] if n] + e["data_lines"]
    if e["separator"] == "wide blanks":
        rows = wide_rows(lines, table)
    elif e["separator"] == "blanks":
        mark = e.get("comment", "\0") + " "
        rows = [(line[len(mark):] if line.startswith(mark) else line).split(" ") for line in lines]
    else:
        rows = list(csv.reader(lines, delimiter=SEPARATOR[e["separator"]]))
    return rows


def number(text, e):
    """(value, half of the last place) of a cell, or None."""
    if not isinstance(text, str):
        return None
    t = text.replace("−", "-").lstrip("+")
    if e.get("thousands"):
        t = t.replace(e["thousands"], "")
    if e["decimal"] == ",":
        if "." in t:
            return None
        t = t.replace(",", ".")
    if not re.fullmatch(r"-?(\d+\.?\d*|\.\d+)(E[-+]?\d+)?", t, re.I):
        return None
    mantissa, _, power = t.upper().partition("E")
    places = len(mantissa.partition(".")[2])
    return float(t), 0.5 * 10.0 ** (int(power or 0) - places)


def moment(text, column):
    """A clock cell as datetime."""
    if isinstance(text, datetime.datetime):
        return text
    form = column["format"]
    if form == "excel serial":
        return EXCEL + datetime.timedelta(seconds=round(float(text.replace(",", ".")) * 86400))
    if form.startswith("unix"):
        return datetime.datetime(1970, 1, 1) + datetime.timedelta(seconds=int(text) / (1000 if form.endswith("ms") else 1))
    if "%b" in form:
        for i, name in sorted(enumerate(MONTHS[column["month_names"]].split(), 1), key=lambda x: -len(x[1])):
            if name in text.lower():
                text = re.sub(name, f"{i:02d}", text.lower())
                break
        form = form.replace("%b", "%m")
    try:
        return datetime.datetime.strptime(text, form)
    except ValueError:
        return datetime.datetime.strptime(text, form.split(" ")[0])  # midnight without its time


class File:
    def __init__(self, toml):
        self.e = e = tomllib.loads(toml.read_text(encoding="utf-8"))
        self.path = toml.parent / e["file"]
        self.faults, self.cells, self.identities, self.worst = [], 0, 0, 0.0
        self.rows = rows_of(self.path, e)
        self.missing = {tuple(m) for m in e.get("missing", [])}
        self.values = {}  # (test, quantity) -> {line: (value, half place)}
        tests = e.get("test_lines") or [[min(e["data_lines"]), max(e["data_lines"])]]
        self.lines = [[n for n in e["data_lines"] if a <= n <= b] for a, b in tests]
        self.check_structure()
        for column in e["columns"]:
            self.check_column(column)
        self.check_clocks()
        for test in {t for t, _ in self.values}:
            self.check_identities(test)

    def fault(self, text):
        self.faults.append(f"{self.path.name}: {text}")

    def at(self, line, position):
        row = self.rows[line - 1]
        return row[position - 1] if position <= len(row) else ""

    def check_structure(self):
        e, count = self.e, len(self.e["columns"])
        between = set(range(min(e["data_lines"]), max(e["data_lines"]))) - set(e["data_lines"]) - set(e.get("repeated_heading_lines", []))
        for n in between:
            if n <= len(self.rows) and any(self.rows[n - 1]):
                self.fault(f"line {n} is among the readings: {self.rows[n - 1]}")
        for n in e["data_lines"]:
            if len(self.rows[n - 1]) > count + (e["traits"]["extra_cells"] == "trailing_separator"):
                self.fault(f"line {n}: {len(self.rows[n - 1])} cells, {count} columns")
        for column in e["columns"]:
            shown = " ".join(str(self.at(n, column["position"])) for n in e["heading_lines"])
            if e["heading_lines"] and column["heading"].split(" ")[-1].strip("_") not in shown:
                self.fault(f"heading {column['heading']} is not in '{shown}'")
            unit = column.get("written", column.get("unit", ""))
            if column.get("unit_source") == "units row" and unit and unit not in self.at(e["unit_line"], column["position"]):
                self.fault(f"unit {unit} is not in line {e['unit_line']}")
            if column.get("unit_source") == "heading" and unit and unit not in shown and column["unit"] != "%":
                self.fault(f"unit {unit} is not in '{shown}'")

    def check_column(self, column):
        e, position, quantity = self.e, column["position"], column["quantity"]
        if quantity in ("ignored", "text", "clock", "date", "time_of_day"):
            return
        if isinstance(column.get("first"), str):
            return self.check_words(column)
        asked = column["unit_source"] == "asked"
        factor = column["true_factor"] * column["true_sign"] if asked else column["factor"] * column["sign"]
        if not math.isclose(abs(factor), FACTOR[column["unit"]], rel_tol=1e-9):
            self.fault(f"column {position}: factor {factor} is not that of '{column['unit']}'")
        values = self.values.setdefault((column.get("test", 1), quantity), {})
        last_line = column.get("last_line", e["data_lines"][-1])
        for line in e["data_lines"]:
            if line > last_line:
                break
            text = self.at(line, position)
            if column["unit"] == "h:mm:ss":
                h, m, s = map(int, text.split(":"))
                got = (3600 * h + 60 * m + s, 0.5)
            else:
                got = number(text, e)
            if (line, position) in self.missing:
                value = None if got is None else got[0]
                if not (str(text).lower() in FILLS or value is not None and (value in (-999.25, -9999.0) or value > 1e29)):
                    self.fault(f"line {line}, column {position}: '{text}' is said to be missing")
            elif got is None:
                self.fault(f"line {line}, column {position}: '{text}' is no number")
            else:
                self.cells += 1
                values[line] = (got[0] * factor, got[1] * abs(factor))
        for key, line in (("first", column.get("first_line", e["first_complete_line"])), ("last", last_line)):
            want = column[f"{key}_as_written"] * factor if asked else column[key]
            if line not in values or abs(values[line][0] - want) > 1e-9 * max(1e-3, abs(want)):
                self.fault(f"column {position} {key}: {values.get(line)} is not {want}")

    def check_words(self, column):
        lines = self.e["data_lines"]
        for key, line in (("first", column.get("first_line", self.e["first_complete_line"])), ("last", lines[-1])):
            if self.at(line, column["position"]) != column[key]:
                self.fault(f"column {column['position']} {key} is not {column[key]}")

    def check_clocks(self):
        e = self.e
        clocks = [c for c in e["columns"] if c["quantity"] in ("clock", "date", "time_of_day")]
        moments = {}
        for column in clocks:
            carried = ""
            for line in [n for n in e["data_lines"] if n <= column.get("last_line", e["data_lines"][-1])]:
                text = self.at(line, column["position"])
                if column["quantity"] == "date" and e["traits"]["clock"] == "date_on_change":
                    text = carried = text or carried
                if text == "":
                    continue
                got = moment(text, column)
                moments.setdefault(column.get("test", 1), {}).setdefault(line, {})[column["quantity"]] = got
                for key, at in (("first", column.get("first_line", e["first_complete_line"])), ("last", e["data_lines"][-1])):
                    if line == at:
                        value = {"date": got.date(), "time_of_day": got.time()}.get(column["quantity"], got)
                        if value != type(value).fromisoformat(column[key]):
                            self.fault(f"column {column['position']} {key}: {value} is not {column[key]}")
        for test, lines in moments.items():
            joined = {n: p["clock"] if "clock" in p else datetime.datetime.combine(p["date"].date(), p["time_of_day"].time())
                      for n, p in lines.items() if "clock" in p or len(p) == 2}
            joined = joined or {n: p["time_of_day"] for n, p in lines.items()}
            for a, b in zip(sorted(joined), sorted(joined)[1:]):
                if any(lines[0] == b for lines in self.lines):  # a second test
                    continue
                over_midnight = "clock" not in lines[b] and "date" not in lines[b] and (joined[a] - joined[b]).total_seconds() > 43200
                if (joined[b] <= joined[a]) != (e.get("row_order") == "reversed") and not over_midnight:
                    self.fault(f"line {b}: the clock does not advance")
            if "elapsed_s" in e and joined:
                got = abs((joined[e["data_lines"][-1]] - joined[e["first_complete_line"]]).total_seconds())
                if abs(got - e["elapsed_s"]) > 1 and abs(got + e["elapsed_s"] - 86400) > 1:
                    self.fault(f"elapsed time: {got} is not {e['elapsed_s']}")
            if (test, "time") in self.values:
                times = self.values[test, "time"]
                for a in joined:
                    first = min(n for n in next(lines for lines in self.lines if a in lines) if n in joined)
                    if abs(abs((joined[a] - joined[first]).total_seconds()) - abs(times[a][0] - times[first][0])) > 61:
                        self.fault(f"line {a}: clock and elapsed time differ")
        if "elapsed_s" in e and (1, "time") in self.values:
            times = self.values[1, "time"]
            got = times[e["data_lines"][-1]], times[e["first_complete_line"]]
            if abs(abs(got[0][0] - got[1][0]) - e["elapsed_s"]) > got[0][1] + got[1][1] + 0.5:
                self.fault(f"elapsed time: {got} is not {e['elapsed_s']}")

    def holds(self, name, residuals):
        """residuals: pairs (residual, tolerance) of all rows."""
        self.identities += 1
        for residual, tolerance in residuals:
            self.worst = max(self.worst, abs(residual) / tolerance)
            if abs(residual) > 1.0001 * tolerance + 1e-9:
                return self.fault(f"{name}: {residual:.3g} is beyond the rounding of {tolerance:.3g}")

    def linear(self, name, test, parts, constant=False, noise=0.0):
        """The sum of coefficient times quantity is zero in all rows, or the same in all rows of a test within the noise of its channels."""
        noisy = self.e["traits"]["noise"] == "yes"
        if all((test, q) in self.values for q in parts):
            columns = [(f, self.values[test, q]) for q, f in parts.items()]
            for lines in self.lines:
                rows = [n for n in lines if all(n in v for _, v in columns)]
                sums = [(sum(f * v[n][0] for f, v in columns), sum(abs(f) * v[n][1] for f, v in columns)) for n in rows]
                if constant:
                    sums = [(s - sums[0][0], t + sums[0][1] + (2.05 * noise if noisy else 0)) for s, t in sums]
                self.holds(name, sums)

    def product(self, name, test, quantities, function, slack=0.0):
        """function(*values) is zero in all rows; the tolerance is the sum of the changes that each cell's rounding makes.

        slack: a relative one of the first quantity, from the rounding of a label.
        """
        if all((test, q) in self.values for q in quantities):
            columns = [self.values[test, q] for q in quantities]
            out = []
            for n in [n for lines in self.lines for n in lines if all(n in v for v in columns)]:
                x = [v[n][0] for v in columns]
                middle = function(*x)
                tolerance = 1e-9 + slack * abs(x[0])
                for i, v in enumerate(columns):
                    changes = []
                    for side in (-1, 1):
                        moved = x[:]
                        moved[i] += side * v[n][1]
                        changes.append(abs(function(*moved) - middle))
                    tolerance += max(changes)
                out.append((middle, 1.02 * tolerance))
            self.holds(name, out)

    def check_identities(self, test):
        q, t, u, du = "deviator_stress", "half_deviator_stress", "pore_pressure", "excess_pore_pressure"
        s1, s3, e1, e3 = "axial_stress", "radial_stress", "effective_axial_stress", "effective_radial_stress"
        p, p2, cell = "mean_effective_stress", "mean_effective_stress_2d", "cell_pressure"
        for total in (s3, cell):
            self.linear("q = σ1 - σ3", test, {q: 1, s1: -1, total: 1})
            self.linear("σ3 = σ3' + u", test, {total: 1, e3: -1, u: -1})
            self.linear("p' = σ3 - u + q/3", test, {p: 1, total: -1, u: 1, q: -1 / 3})
            self.linear("s' = σ3 - u + t", test, {p2: 1, total: -1, u: 1, t: -1})
            self.linear("σ3 - Δu - σ3' constant", test, {total: 1, du: -1, e3: -1}, constant=True)
        self.linear("q = σ1' - σ3'", test, {q: 1, e1: -1, e3: 1})
        self.linear("2 t = σ1' - σ3'", test, {t: 2, e1: -1, e3: 1})
        self.linear("q = 2 t", test, {q: 1, t: -2})
        self.linear("p' = σ3' + q/3", test, {p: 1, e3: -1, q: -1 / 3})
        self.linear("s' = σ3' + t", test, {p2: 1, e3: -1, t: -1})
        self.linear("p' = s' - t/3", test, {p: 1, p2: -1, t: 1 / 3})
        self.linear("σ1 = σ1' + u", test, {s1: 1, e1: -1, u: -1})
        self.linear("p = p' + u", test, {"mean_stress": 1, p: -1, u: -1})
        self.linear("u - Δu constant", test, {u: 1, du: -1}, constant=True)
        self.linear("εv = ε1 + 2 εr", test, {"volumetric_strain": 1, "axial_strain": -1, "radial_strain": -2})
        if self.e["traits"]["kind"] in ("ICU", "CID", "CSD", "cyclic", "UU"):
            self.linear("constant cell pressure", test, {cell: 1}, constant=True, noise=0.2)
            self.linear("constant σ3", test, {s3: 1}, constant=True, noise=0.2)
            self.linear("p' - q/3 + u constant", test, {p: 1, q: -1 / 3, u: 1}, constant=True, noise=0.2)
            self.linear("s' - t + u constant", test, {p2: 1, t: -1, u: 1}, constant=True, noise=0.2)
            if self.e["traits"]["kind"] == "CID":
                self.linear("p' - q/3 constant", test, {p: 1, q: -1 / 3}, constant=True, noise=0.35)
                self.linear("s' - t constant", test, {p2: 1, t: -1}, constant=True, noise=0.35)
                self.linear("constant pore pressure", test, {u: 1}, constant=True, noise=0.15)
        self.product("η = q/p'", test, ["stress_ratio", q, p], lambda r, x, m: r * m - x)
        self.product("R = σ1'/σ3'", test, ["principal_stress_ratio", e1, e3], lambda r, a, b: r * b - a)
        self.product("F = q A", test, ["axial_force", q, "current_area"], lambda f, x, a: f - x * a * 1e-6)
        labels = self.e.get("labels", {})
        height, diameter = labels.get("height_mm"), labels.get("diameter_mm")
        if height:
            self.product("ΔL = ε H", test, ["axial_displacement", "axial_strain"], lambda d, s: d - s * height, 0.0013 / height)
        elif (test, "axial_displacement") in self.values and (test, "axial_strain") in self.values:
            strains, shortening = self.values[test, "axial_strain"], self.values[test, "axial_displacement"]
            far = max((n for n in strains if n in shortening), key=lambda n: abs(strains[n][0]))
            height = shortening[far][0] / strains[far][0] if strains[far][0] else None
            if height:
                if not 60 < height < 210:
                    self.fault(f"height {height}")
                slack = (shortening[far][1] + height * strains[far][1]) / abs(strains[far][0])  # of this height
                self.holds("ΔL = ε H", [(shortening[n][0] - height * strains[n][0],
                                         shortening[n][1] + height * strains[n][1] + slack * abs(strains[n][0]))
                                        for n in strains if n in shortening])
        if diameter:
            area, slack = math.pi / 4 * diameter**2, 0.0026 / diameter  # a label has four decimals of an inch
            undrained = self.e["traits"]["kind"] in ("ICU", "UU", "UC", "cyclic")
            if undrained:
                self.product("F = q A0/(1 - ε)", test, ["axial_force", q, "axial_strain"],
                             lambda f, x, s: f - x * area * 1e-6 / (1 - s), slack)
                self.product("A = A0/(1 - ε)", test, ["current_area", "axial_strain"], lambda a, s: a - area / (1 - s), slack)
            self.product("A = A0 (1 - εv)/(1 - ε)", test, ["current_area", "volumetric_strain", "axial_strain"],
                         lambda a, v, s: a - area * (1 - v) / (1 - s), slack)
        self.check_signs(test)
        self.check_sizes(test, diameter)

    def check_sizes(self, test, diameter):
        """Stresses and strains are those of a soil specimen: a wrong unit is beyond them by a factor of 6 or more."""
        bounds = {"axial_strain": (-0.21, 0.23), "volumetric_strain": (-0.08, 0.08),
                  "axial_displacement": (-42, 46), "current_area": (700, 11000), "specimen_height": (50, 245),
                  "void_ratio": (0.3, 1.2), "axial_force": (-6, 25), "volume_change": (-1.3e5, 1.3e5)}
        for quantity in ("deviator_stress", "axial_stress", "effective_axial_stress", "cell_pressure", "pore_pressure", "radial_stress"):
            bounds[quantity] = (-700, 2500)
        for quantity, (low, high) in bounds.items():
            for value, _ in self.values.get((test, quantity), {}).values():
                if not low <= value <= high:
                    return self.fault(f"{quantity} {value} is not between {low} and {high}")
        forces = self.values.get((test, "axial_force"), {})
        if diameter and forces:
            stress = max(abs(v) for v, _ in forces.values()) / (math.pi / 4 * diameter**2) * 1e6
            if not 4 < stress < 2600:
                self.fault(f"force over area is {stress} kPa")

    def check_signs(self, test):
        """A drained specimen contracts at first and a consolidating one always; q and axial strain have one sign unless it is cyclic."""
        kind = self.e["traits"]["kind"]
        rows = self.lines[0][::-1] if self.e.get("row_order") == "reversed" else self.lines[0]

        if kind in ("CID", "consolidation"):
            for quantity, sign in (("volumetric_strain", 1), ("volume_change", 1), ("back_volume", -1), ("void_ratio", -1)):
                values = self.values.get((test, quantity), {})
                there = [n for n in rows if n in values]
                early = [values[n][0] - values[there[0]][0] for n in there[:max(3, len(there) // 6)]] if there else []
                if early and sign * max(early, key=abs) < 0:
                    self.fault(f"{quantity} begins with the wrong sign")
        if kind in ("ICU", "CID", "CSD", "UU", "UC"):
            wanted = -1 if self.e["traits"]["direction"] == "extension" else 1
            for quantity in ("deviator_stress", "half_deviator_stress", "axial_force", "axial_strain", "axial_displacement"):
                if wanted * sum(value for value, _ in self.values.get((test, quantity), {}).values()) < 0:
                    self.fault(f"{quantity} has the wrong sign")
        for quantity in ("cell_pressure", "effective_radial_stress", "mean_effective_stress", "effective_axial_stress"):
            if any(v[0] < -v[1] for v in self.values.get((test, quantity), {}).values()):
                self.fault(f"{quantity} below zero")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.split("\n")[0])
    files = [File(toml) for toml in sorted(pathlib.Path(sys.argv[1]).glob("*.expected.toml"))]
    for file in files:
        print(*file.faults, sep="\n", end="\n" if file.faults else "")
    bad = sum(bool(f.faults) for f in files)
    print(f"{len(files)} files, {sum(f.cells for f in files)} cells, {sum(f.identities for f in files)} identities, "
          f"largest residual {max((f.worst for f in files), default=0):.2f} of the rounding, {bad} files with faults")
    return 1 if bad or not files else 0


if __name__ == "__main__":
    sys.exit(main())
