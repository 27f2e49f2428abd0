#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""compare.py EXPECTED.csv.xz [RESULTS.csv] [--refresh]

Compares results of run_tests.py with stored ones, and lists each test and form whose result changed, with the columns that did. Tests that
are not in RESULTS.csv are not compared. Exit status 1 if any differs. --refresh stores RESULTS.csv instead, in place of the results that
EXPECTED.csv.xz has for the same tests. Without RESULTS.csv it prints how many programmes have stored results.
"""
import argparse
import csv
import io
import lzma
import pathlib
import sys

# Of numbers with a point; all else is compared as text.
MAX_DIFFERENCE = 1e-4
# A simulation that is near the time limit depends on the machine.
SKIPPED_OUTCOME = "time limit"


def read(path):
    opened = lzma.open(path, "rt", encoding="utf-8", newline="") if path.suffix == ".xz" else open(path, encoding="utf-8", newline="")
    with opened as file:
        return {(row["number"], row["form"]): row for row in csv.DictReader(file)}


def same(a, b):
    if a == b:
        return True
    if "." not in a + b:
        return False  # words, readings
    try:
        x, y = float(a), float(b)
    except ValueError:
        return False
    return abs(x - y) <= MAX_DIFFERENCE * max(abs(x), abs(y), 1e-3)


def differences(found, expected):
    """Lines of text, one for each test and form."""
    numbers = {number for number, _ in found}
    out = []
    for key in sorted({k for k in found.keys() | expected.keys() if k[0] in numbers}, key=lambda k: (int(k[0]), k[1])):
        name = f"{key[0]}, {key[1]}: "
        if key not in expected or key not in found:
            out.append(name + ("new" if key in found else "missing"))
            continue
        if SKIPPED_OUTCOME in (found[key]["outcome"], expected[key]["outcome"]):
            continue
        changed = [f"{c} {expected[key].get(c) or '-'} -> {v or '-'}" for c, v in found[key].items() if not same(v, expected[key].get(c, ""))]
        if changed:
            out.append(name + "; ".join(changed))
    return out


def merged(expected, results):
    """Stored results with those of the tests that were run again, in the order of the numbers."""
    numbers = {number for number, _ in results}
    kept = {key: row for key, row in expected.items() if key[0] not in numbers} | results
    return {key: kept[key] for key in sorted(kept, key=lambda key: int(key[0]))}


def store(path, results):
    text = io.StringIO()
    writer = csv.DictWriter(text, list(next(iter(results.values()))), lineterminator="\n")
    writer.writeheader()
    writer.writerows(results.values())
    path.write_bytes(lzma.compress(text.getvalue().encode(), preset=9 | lzma.PRESET_EXTREME))
    print(f"{len(results)} results, {path.stat().st_size} bytes in {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("expected", type=pathlib.Path, metavar="EXPECTED.csv.xz")
    parser.add_argument("results", type=pathlib.Path, metavar="RESULTS.csv", nargs="?")
    parser.add_argument("--refresh", action="store_true", help="store the results instead")
    options = parser.parse_args()
    expected = read(options.expected) if options.expected.exists() else {}
    if not options.results:
        print(max((int(number) for number, _ in expected), default=0))
        return 0
    results = read(options.results)
    if options.refresh:
        store(options.expected, merged(expected, results))
        return 0
    found = differences(results, expected)
    print(*found, sep="\n", end="\n" if found else "")
    print(f"{len(results)} results compared, {len(found)} differ")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
