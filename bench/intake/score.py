#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""score.py FOLDER [OPTIONS] -- COMMAND...

Runs COMMAND on each table of FOLDER (written by make_tables.py) and compares what it prints with NAME.expected.toml. The path of the file
takes the place of {} in COMMAND, or is appended. COMMAND prints what it understood in the format of expected.toml: `kind`, `ask`,
`missing`, `data_lines` or `readings`, `tests`, `row_order`, `elapsed_s`, [labels], and for each of [[columns]] `position`, `quantity`,
`unit`, `unit_source`, `factor`, `sign`, `first`, `last`. A key that is not printed is not compared, except of columns, `missing`, `tests`,
`row_order` and `ask`. Exit status 0 means that the file was read; any other status means that it was refused, with or without a proposal.

Each file has one outcome:
  right     every column has its quantity, unit, factor, sign, first and last value, every missing cell is missing, nothing is asked
  asked     right, and the reader asks for what the file does not contain, and for nothing else
  needless  right, and the reader asks for something that the file contains
  proposed  the file was refused with a proposal that is right
  unused    right, but a column with a known meaning was left out
  unasked   the meaning is right, but something that the file does not contain was assumed without a question
  refused   the file was refused without a proposal, or with one that is wrong
  failed    the command crashed, did not end in time, or printed no TOML
  wrong     the file was read with a wrong meaning
`read` is right + asked. Exit status 1 if less than 95 % of the files are read or if any file is read with a wrong meaning.
"""
import argparse
import collections
import concurrent.futures
import datetime
import math
import pathlib
import re
import subprocess
import sys
import tomllib

OUTCOMES = ["right", "asked", "needless", "proposed", "unused", "unasked", "refused", "failed", "wrong"]
READ = ("right", "asked")
MIN_READ = 0.95
UNUSED = {"", "ignored", "text"}
CLOCKS = {"clock", "date", "time_of_day"}
AUXILIARY = {"reading_number", "temperature", "specimen_height", "specimen_diameter", "cell_volume", "force_reading"}
SAME = [{"cell_pressure", "radial_stress"}, {"dial_reading", "axial_displacement"}]
SAME_UNCONFINED = [{"deviator_stress", "axial_stress"}]
OPPOSITE = {"back_volume", "volume_change"}  # one is minus the other, but for the zero
KINDS = [("cyclic", "cyclic"), ("uu", "uu"), ("uc", "uc"), ("consolidation only", "consolidation"), ("undrained", "undrained"),
         ("cu with pore", "undrained"), ("drained", "drained")]


def wilson(hits, count, z=1.96):
    """95 % interval of a proportion (Wilson 1927)."""
    if not count:
        return 0.0, 1.0
    p = hits / count
    middle = (p + z * z / (2 * count)) / (1 + z * z / count)
    half = z / (1 + z * z / count) * math.sqrt(p * (1 - p) / count + z * z / (4 * count * count))
    return max(0.0, middle - half), min(1.0, middle + half)


def kind_class(text):
    return next((kind for word, kind in KINDS if re.search(rf"\b{word}\b", text.lower())), "")


def question(text):
    """A question in one form, whatever its words: ("unit", "Time"), ("height", "") ..."""
    t = text.lower().replace("’", "'").replace("′", "'").strip()
    for subject in ("unit", "sign", "meaning"):
        if t.startswith(subject + " of "):
            return subject, t[len(subject) + 4:]
    for key in ("height", "diameter", "cell pressure", "back pressure", "effective consolidation stress"):
        if t.startswith(key):
            return key, ""
    if "day" in t and "month" in t:
        return "order of day and month", ""
    if "s'" in t and re.search(r"\bt\b", t):
        return "s' and t", ""
    return t, ""


def questions(document, key="ask"):
    return {question(part) for text in document.get(key, []) for part in re.split(r" and (?=diameter)", text)}


def close(a, b, tolerance=1e-6):
    return abs(a - b) <= tolerance * max(abs(a), abs(b)) + 1e-9


def same_moment(a, b):
    """Two ISO texts, or TOML dates and times, within a second."""
    def parse(x):
        if isinstance(x, datetime.time) or isinstance(x, str) and re.fullmatch(r"\d\d:\d\d(:.*)?", x):
            x = x if isinstance(x, datetime.time) else datetime.time.fromisoformat(x)
            return datetime.datetime.combine(datetime.date(2000, 1, 1), x)
        x = x.isoformat() if isinstance(x, (datetime.date, datetime.datetime)) else str(x)
        return datetime.datetime.fromisoformat(x).replace(tzinfo=None)
    try:
        return abs((parse(a) - parse(b)).total_seconds()) <= 1
    except ValueError:
        return False


class Comparison:
    """What an answer makes of a file, compared with the expected document."""

    def __init__(self, expected, answer):
        self.e, self.a = expected, answer
        self.wrong, self.unused, self.unasked, self.needless = [], [], [], []
        self.asked = questions(answer)
        self.columns = {c["position"]: c for c in answer.get("columns", []) if "position" in c}
        self.unit_asked = set()  # positions whose unit or meaning is asked
        self.find_asked_columns()
        for column in expected["columns"]:
            self.compare_column(column, self.columns.get(column["position"], {}))
        for position in set(self.columns) - {c["position"] for c in expected["columns"]}:
            if self.columns[position].get("quantity", "") not in UNUSED:
                self.wrong.append(f"column {position} does not exist")
        self.compare_file()
        self.compare_missing()
        self.compare_questions()

    def find_asked_columns(self):
        names = {c["heading"].lower(): c["position"] for c in self.e["columns"]} | \
            {c.get("heading", "").lower(): p for p, c in self.columns.items()}
        names |= {name.replace("_", " "): position for name, position in names.items()}
        self.unit_asked |= {p for p, c in self.columns.items() if c.get("unit_source") == "asked" or c.get("quantity") == "asked"}
        for subject, name in self.asked:
            if subject in ("unit", "meaning") and name in names:
                self.unit_asked.add(names[name])
            if subject == "sign" and names.get(name) in {c["position"] for c in self.e["columns"] if c.get("unit_source") == "asked"}:
                self.unit_asked.add(names[name])
        if ("headings", "") in self.asked:
            self.unit_asked |= {c["position"] for c in self.e["columns"]}

    def same_quantity(self, want, got):
        groups = SAME + (SAME_UNCONFINED if self.e.get("traits", {}).get("kind") == "UC" else [])
        return want == got or any({want, got} <= g for g in groups)

    def compare_column(self, want, got):
        position, quantity = want["position"], want["quantity"]
        where = f"column {position} ({want['heading']})"
        found = got.get("quantity", "")
        if quantity in UNUSED:
            if found not in UNUSED and found not in AUXILIARY and position not in self.unit_asked:
                self.wrong.append(f"{where}: {found} is not {quantity}")
            return
        if position in self.unit_asked:
            listed = set(got.get("candidates", [])) | {found, "asked", ""}
            if found not in ("", "asked") and quantity not in listed and not self.same_quantity(quantity, found):
                self.wrong.append(f"{where}: {found} is not {quantity}")
            elif want.get("unit_source") != "asked" and ("unit", want["heading"].lower()) not in self.may:
                self.needless.append(f"{where}: the unit is known")
            return
        if found in UNUSED:
            if quantity not in AUXILIARY and want.get("unit_source") != "asked":
                self.unused.append(f"{where}: {quantity} is not used")
            return
        if quantity in CLOCKS or found in CLOCKS:
            return self.compare_clock(want, got, where)
        flip = -1 if {quantity, found} == OPPOSITE else 1
        if flip == 1 and not self.same_quantity(quantity, found):
            self.wrong.append(f"{where}: {found} is not {quantity}")
            return
        if isinstance(want.get("first"), str):
            if any(str(got.get(k, want[k])) != want[k] for k in ("first", "last")):
                self.wrong.append(f"{where}: {got.get('first')} to {got.get('last')} is not {want['first']} to {want['last']}")
            return
        self.compare_numbers(want, got, where, flip)

    @property
    def may(self):
        return questions(self.e, "may_ask")

    def compare_numbers(self, want, got, where, flip):
        asked = want["unit_source"] == "asked"
        if asked and not self.covered("headings"):
            self.unasked.append(f"{where}: the unit was not asked")
        if asked and "true_factor" not in want:
            return
        factor = want["true_factor"] if asked else want["factor"]
        sign = (want["true_sign"] if asked else want["sign"]) * flip
        free = want.get("sign_open", False) or ("sign", want["heading"].lower().replace("_", " ")) in self.asked or \
            ("sign", want["heading"].lower()) in self.asked
        if "factor" in got and not close(got["factor"], factor) and want["unit"] not in ("div", "h:mm:ss"):
            self.wrong.append(f"{where}: factor {got['factor']} is not {factor}")
        if "sign" in got and got["sign"] != sign and not free:
            self.wrong.append(f"{where}: sign {got['sign']} is not {sign}")
        for key in ("first", "last"):
            written = want.get(f"{key}_as_written") if asked else want.get(key)
            value = (written or 0) * (factor * sign if asked else flip)
            if written is not None and key in got and isinstance(got[key], (int, float)):
                a, b = (abs(got[key]), abs(value)) if free else (got[key], value)
                if not close(a, b):
                    self.wrong.append(f"{where}: {key} {got[key]} is not {value}")
        if not {"first", "last"} & set(got):
            self.wrong.append(f"{where}: no first and last value")

    def covered(self, key):
        return (key, "") in self.asked

    def compare_clock(self, want, got, where):
        if want["quantity"] != got.get("quantity"):
            self.wrong.append(f"{where}: {got.get('quantity')} is not {want['quantity']}")
            return
        if want["quantity"] in ("clock", "date") and self.covered("order of day and month"):
            return
        for key in ("first", "last"):
            if key in got and key in want and not same_moment(got[key], want[key]):
                self.wrong.append(f"{where}: {key} {got[key]} is not {want[key]}")

    def compare_file(self):
        e, a = self.e, self.a
        count = len(a["data_lines"]) if "data_lines" in a else a.get("readings")
        if count is not None and count != len(e["data_lines"]):
            self.wrong.append(f"{count} readings are not {len(e['data_lines'])}")
        for key, usual in (("tests", 1), ("row_order", "ascending")):
            if self.covered("headings"):
                continue  # no column is known yet
            if key == "tests" and e.get("kind", "").startswith("two tests"):
                usual = 2
            if a.get(key, usual) != e.get(key, usual):
                self.wrong.append(f"{key} {a.get(key, usual)} is not {e.get(key, usual)}")
        if "elapsed_s" in e and "elapsed_s" in a and abs(e["elapsed_s"] - a["elapsed_s"]) > 1 + 1e-6 * e["elapsed_s"]:
            if not any(c.get("unit_source") == "asked" for c in e["columns"] if c["quantity"] == "time"):
                self.wrong.append(f"elapsed time {a['elapsed_s']} s is not {e['elapsed_s']} s")
        kinds = kind_class(e.get("kind", "")), kind_class(a.get("kind", ""))
        if all(kinds) and kinds[0] != kinds[1]:
            self.wrong.append(f"kind '{a['kind']}' is not '{e['kind']}'")
        labels = a.get("labels", {})
        for key, value in e.get("labels", {}).items():
            if isinstance(labels.get(key), (int, float)) and not close(labels[key], value, 1e-3):
                self.wrong.append(f"label {key} {labels[key]} is not {value}")

    def compare_missing(self):
        used = {c["position"] for c in self.e["columns"] if self.columns.get(c["position"], {}).get("quantity", "") not in UNUSED}
        want = {tuple(m) for m in self.e.get("missing", []) if m[1] in used}
        got = {tuple(m) for m in self.a.get("missing", [])}
        for cell in sorted(want - got)[:3]:
            self.wrong.append(f"line {cell[0]}, column {cell[1]}: a missing value was read as a number")
        end = self.e["data_lines"][-1]
        last = {c["position"]: c.get("last_line", end) for c in self.e["columns"] if c["quantity"] not in UNUSED | CLOCKS}
        extra = sorted(m for m in got - want if m[1] in last and m[1] in used and m[0] <= last[m[1]] and m[0] in set(self.e["data_lines"]))
        for cell in extra[:3]:
            self.wrong.append(f"line {cell[0]}, column {cell[1]}: a value was read as missing")

    def compare_questions(self):
        required = questions(self.e)
        units = {c["heading"].lower(): c["position"] for c in self.e["columns"]}
        for key, name in required:
            if key in ("unit", "meaning"):
                covered = units.get(name) in self.unit_asked or (key, name) in self.asked
            elif key == "headings":
                covered = all(c["position"] in self.unit_asked for c in self.e["columns"])
            else:
                covered = (key, name) in self.asked
            if not covered and not any(f"({name})" in u.lower() for u in self.unasked):
                self.unasked.append(f"not asked: {key} {name}".strip())
        known = required | self.may
        for key, name in self.asked - known:
            if key in ("unit", "meaning") and units.get(name) in self.unit_asked:
                continue  # counted with its column
            if ("headings", "") not in known:
                self.needless.append(f"asked: {key} {name}".strip())

    def asks(self):
        return bool(self.asked or self.unit_asked)


def outcome(expected, answer, refused):
    """(outcome, reasons) of one file. answer: the parsed TOML or None."""
    if answer is None or not answer.get("columns"):
        return ("refused", ["no proposal"]) if refused else ("failed", ["no columns were printed"])
    c = Comparison(expected, answer)
    if refused:
        return ("refused", c.wrong) if c.wrong else ("proposed", c.unused + c.unasked + c.needless)
    for name, reasons in (("wrong", c.wrong), ("unasked", c.unasked), ("unused", c.unused), ("needless", c.needless)):
        if reasons:
            return name, reasons
    return ("asked" if c.asks() else "right"), []


def run(command, path, timeout):
    """(parsed answer or None, whether the file was refused, text of a failure)."""
    words = [w.replace("{}", str(path)) for w in command] if any("{}" in w for w in command) else command + [str(path)]
    try:
        done = subprocess.run(words, capture_output=True, timeout=timeout, check=False)
    except subprocess.TimeoutExpired:
        return None, False, f"no answer within {timeout} s"
    if done.returncode < 0 or done.returncode >= 126:
        return None, False, f"exit status {done.returncode}"
    try:
        return tomllib.loads(done.stdout.decode("utf-8")), done.returncode != 0, ""
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        return None, done.returncode != 0, "" if done.returncode else f"no TOML: {error}"


def score_file(toml, command, timeout):
    expected = tomllib.loads(toml.read_text(encoding="utf-8"))
    answer, refused, failure = run(command, toml.parent / expected["file"], timeout)
    result, reasons = ("failed", [failure]) if failure else outcome(expected, answer, refused)
    return expected, result, reasons


def percent(hits, count):
    low, high = wilson(hits, count)
    return f"{100 * hits / count:6.1f} [{100 * low:5.1f}, {100 * high:5.1f}]"


def table(results, only=()):
    """Lines of text: outcomes of all files, then by trait. results: (traits, outcome)."""
    def line(name, outcomes):
        counts = collections.Counter(outcomes)
        n = len(outcomes)
        return (f"{name:<34}{n:>7}" + "".join(f"{counts[o]:>9}" for o in OUTCOMES) + "  " +
                percent(sum(counts[o] for o in READ), n) + "  " + percent(counts["wrong"], n))
    head = f"{'trait':<34}{'files':>7}" + "".join(f"{o:>9}" for o in OUTCOMES) + f"  {'read %':<21}  {'wrong %':<21}"
    lines = [head, line("all", [o for _, o in results])]
    groups = {}
    for traits, result in results:
        for key, value in traits.items():
            if key != "seed" and (not only or key in only):
                groups.setdefault(key, {}).setdefault(str(value), []).append(result)
    for key, values in groups.items():
        if len(values) > 1 or only:
            lines += [""] + [line(f"{key}={value}", values[value]) for value in sorted(values, key=lambda v: -len(values[v]))]
    return lines


def main():
    arguments = sys.argv[1:]
    at = arguments.index("--") if "--" in arguments else len(arguments)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--by", action="append", default=[], metavar="TRAIT", help="only this trait in the table (repeatable)")
    parser.add_argument("--list", action="append", default=[], metavar="OUTCOME", choices=OUTCOMES,
                        help="list the files with this outcome and why (repeatable)")
    parser.add_argument("--jobs", type=int, default=1, help="commands at the same time [1]")
    parser.add_argument("--timeout", type=float, default=20, help="seconds for one file [20]")
    options = parser.parse_args(arguments[:at])
    command = arguments[at + 1:]
    if not command:
        parser.error("missing -- COMMAND")
    tomls = sorted(options.folder.glob("*.expected.toml"))
    if not tomls:
        parser.error(f"no *.expected.toml in {options.folder}")
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        scored = list(pool.map(lambda toml: score_file(toml, command, options.timeout), tomls))
    for expected, result, reasons in scored:
        if result in options.list:
            print(f"{expected['file']}: {result}: {'; '.join(reasons[:4])}")
    print(*table([(expected.get("traits", {}), result) for expected, result, _ in scored], options.by), sep="\n")
    outcomes = [result for _, result, _ in scored]
    return 1 if outcomes.count("wrong") or sum(o in READ for o in outcomes) < MIN_READ * len(outcomes) else 0


if __name__ == "__main__":
    sys.exit(main())
