#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_structure.py FOLDER PROGRAM [--list KEY]... [--by TRAIT]...

Runs PROGRAM (bench_print_structure) on the files of a folder of make_tables.py and compares encoding, separator, number format, headings,
units and rows with the *.expected.toml. Prints the fraction that is right by key and by trait."""
import argparse
import collections
import pathlib
import re
import subprocess
import sys
import tomllib

CODEC = {"Windows-1250": "cp1250", "Windows-1251": "cp1251", "Windows-1252": "cp1252", "Windows-1254": "cp1254", "EUC-KR": "cp949"}
KEYS = ("encoding", "separator", "decimal", "thousands", "comment", "heading_lines", "unit_line", "data_lines", "repeated_heading_lines",
        "blocks", "headings")


def same_text(data, expected, found):
    """True if both encodings give the same text."""
    try:
        texts = [data.decode(name).lstrip("\ufeff") for name in (expected, CODEC.get(found, found))]
    except (UnicodeDecodeError, LookupError):
        return False
    return texts[0] == texts[1]


def squeezed(text):
    return re.sub(r"[ _]", "", text).lower()


def wrong_keys(expected, found, data):
    """The keys that differ, with both values."""
    beside = "test_lines" not in expected and (expected["kind"].startswith("two tests") or "tests" in expected)
    blocks = 2 if beside else 0
    want = {k: expected.get(k, d) for k, d in (("separator", ""), ("decimal", "."), ("heading_lines", []), ("unit_line", 0),
                                                  ("data_lines", []), ("repeated_heading_lines", []))}
    got = {k: found.get(k, type(v)()) for k, v in want.items()}
    wrong = {k: (want[k], got[k]) for k in want if want[k] != got[k]}
    if want["separator"] == "sheet":
        for key in ("separator", "decimal"):  # of numbers that are text, the workbook reader makes numbers
            wrong.pop(key, None)
    if want["separator"] != "sheet" and not same_text(data, expected["encoding"], found.get("encoding", "")):
        wrong["encoding"] = expected["encoding"], found.get("encoding", "")
    thousands = expected.get("thousands", "").replace("\u00a0", " ")
    if thousands != found.get("thousands", ""):
        wrong["thousands"] = thousands, found.get("thousands", "")
    marked = any(line.lstrip(b'"').startswith(expected.get("comment", "#").encode()) for line in data.splitlines())
    if marked and expected.get("comment", "") not in ("", found.get("comment", "")):
        wrong["comment"] = expected["comment"], found.get("comment", "")
    if blocks != len(found.get("blocks", [])):
        wrong["blocks"] = blocks, len(found.get("blocks", []))
    names = found.get("headings", [])
    for column in expected["columns"]:
        name = names[column["position"] - 1] if column["position"] <= len(names) else ""
        if want["heading_lines"] and squeezed(column["heading"]) not in squeezed(name):
            wrong["headings"] = column["heading"], name
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("program")
    parser.add_argument("--list", action="append", default=[], help="print the files in which this key is wrong (repeatable)")
    parser.add_argument("--by", action="append", default=[], help="print the fraction by this trait (repeatable)")
    options = parser.parse_args()
    documents = [tomllib.loads(p.read_text(encoding="utf-8")) for p in sorted(options.folder.glob("*.expected.toml"))]
    paths = [str(options.folder / d["file"]) for d in documents]
    printed = subprocess.run([options.program, *paths], capture_output=True, check=True).stdout.decode("utf-8")
    tables = collections.defaultdict(list)
    for table in tomllib.loads(printed)["file"]:
        tables[table["file"]].append(table)
    counts, traits = collections.Counter(), collections.defaultdict(lambda: [0, 0])
    for document, path in zip(documents, paths):
        found = [t for t in tables[path] if t.get("sheet", "") == document.get("sheet", "")]
        wrong = wrong_keys(document, found[0] if found else {}, pathlib.Path(path).read_bytes())
        counts.update(wrong.keys())
        counts["files"] += 1
        counts["right"] += not wrong
        for key in options.list:
            if key in wrong or key == "all" and wrong:
                print(pathlib.Path(path).name, {k: tuple(str(v)[:150] for v in pair) for k, pair in wrong.items()})
        for trait, value in document.get("traits", {}).items():
            traits[trait, str(value)][0] += not wrong
            traits[trait, str(value)][1] += 1
    for (trait, value), (right, files) in sorted(traits.items()):
        if trait in options.by or "all" in options.by and right < files and trait != "seed":
            print(f"{trait}={value}: {right} of {files}, {100 * right / files:.1f} %")
    print(", ".join(f"{key} {counts[key]} wrong" for key in KEYS))
    print(f"{counts['right']} of {counts['files']} right, {100 * counts['right'] / max(counts['files'], 1):.2f} %")
    return 0 if counts["right"] == counts["files"] else 1


if __name__ == "__main__":
    sys.exit(main())
