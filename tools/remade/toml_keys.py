# SPDX-License-Identifier: GPL-3.0-or-later
"""The keys of TOML files that triax accepts, from the program: a key that no table has is put into each table of each sample, and the
message about it lists the accepted keys.
"""
import pathlib
import re
import tomllib

from remade.program import ROOT, Triax

UNKNOWN = "no_such_key"
# Tables that no sample has, for the kinds of file that have them.
MORE_TABLES = {"simulate": ["[[operator]]\naction = \"hold\"\nat_min = 1.0"]}
# Keys of a table whose values decide which others are accepted.
DECIDING = {"stages": ["axial", "action"], "segments": ["frame"]}
# Kind of file, page that explains the keys, samples, command.
KINDS = [
    ("Programmes of the apparatus", "programmes.md", ["samples/programmes/**/*.toml"], ["simulate"]),
    ("Programmes of a specimen of grains", "../how-to/grains.md", ["samples/grains/*.toml"], ["grains"]),
    ("Rigs", "../how-to/instruments.md", ["samples/rigs/*.toml"], ["rig", "check"]),
    ("Paths of a material point", "paths.md", ["samples/paths/*.toml"], ["element"]),
    ("Dialects", "foreign-tables.md", ["samples/dialects/*.toml", "lab/records/dialects/*.toml"],
     ["replay", "samples/dialects/my_lab_record.txt", "--dialect"]),
    ("Parameter sets", "../how-to/laws.md", ["samples/materials/*.toml", "lab/materials/*.toml"], ["materials", "--materials"]),
]


def with_unknown_key(text: str, more_tables: list[str]) -> list[str]:
    """The document with the key in one of its tables, once for each table."""
    key = f"{UNKNOWN} = 1"
    places = [(0, f"{key}\n")]
    places += [(m.end(), f"\n{key}") for m in re.finditer(r"^\[.+?\]{1,2}[ \t]*(?:#.*)?$", text, re.M)]
    places += [(m.end(), f" {key}, ") for m in re.finditer(r"^[\w.\"]+ *= *\{|(?<=[\[,{] )\{|(?<== )\{", text, re.M)]
    places += [(len(text), f"\n{table}\n{key}\n") for table in more_tables]
    return [text[:at] + added + text[at:] for at, added in places]


def place(document: dict, law: str, prefix: str = "") -> tuple[str, str] | None:
    """The name of the table that has the key, and the value that decides about its keys, as in ("stages", "axial rate")."""
    if UNKNOWN in document:
        name = re.sub(r"^sets\..*", "sets.NAME", prefix)
        kinds = [f"{key} = \"{document[key]}\"" for key in DECIDING.get(name, []) if key in document]
        return name, law if name == "sets.NAME" else ", ".join(kinds)
    for name, value in document.items():
        path = f"{prefix}.{name}" if prefix else name
        for inner in value if isinstance(value, list) else [value]:
            if isinstance(inner, dict) and (found := place(inner, law, path)):
                return found
    return None


def accepted_keys(triax: Triax, patterns: list[str], command: list[str]) -> dict[tuple[str, str], list[str]]:
    """The accepted keys of each kind of table, in the order of the first message that lists them."""
    tables: dict[tuple[str, str], list[str]] = {}
    for sample in sorted(file for pattern in patterns for file in ROOT.glob(pattern)):
        beside = triax.folder / "keys"
        beside.mkdir(exist_ok=True)
        for text in with_unknown_key(sample.read_text(encoding="utf-8"), MORE_TABLES.get(command[0], [])):
            try:
                document = tomllib.loads(text)
            except tomllib.TOMLDecodeError:
                continue  # a brace inside a text
            found = place(document, f'law = "{document.get("law")}"')
            if found is None:
                continue
            file = pathlib.Path(beside / sample.name)
            file.write_text(text, encoding="utf-8")
            told = triax.shell(f"triax {' '.join(command)} {file}").stdout
            if listed := re.search(rf"unknown key '{UNKNOWN}'.*?must be one of: ([^)\n]*)", told):
                keys = tables.setdefault(found, [])
                keys += [key for key in listed[1].split(", ") if key not in keys]
    return tables


def grouped(tables: dict[tuple[str, str], list[str]]) -> dict[tuple[str, ...], list[tuple[str, str]]]:
    """Tables that accept the same keys, by these keys."""
    groups: dict[tuple[str, ...], list[tuple[str, str]]] = {}
    for table, keys in tables.items():
        same = next((known for known in groups if set(known) == set(keys)), tuple(keys))
        groups.setdefault(same, []).append(table)
    return groups


def title_of(tables: list[tuple[str, str]]) -> str:
    names = dict.fromkeys(f"`[{table}]`" if table else "Beginning of the file" for table, _ in tables)
    kinds = dict.fromkeys(f"`{kind}`" for _, kind in tables if kind)
    return ", ".join(names) + (f" with {', '.join(kinds)}" if kinds else "")


def toml_keys_page(triax: Triax) -> list[str]:
    lines = ["# TOML keys", "", "The keys that triax accepts in each table of each kind of file. A suffix of a key is its unit.", ""]
    for title, page, patterns, command in KINDS:
        lines += [f"## {title}", "", f"The page [{pathlib.Path(page).stem}]({page}) explains the keys.", ""]
        for keys, tables in grouped(accepted_keys(triax, patterns, command)).items():
            lines.append(f"- **{title_of(tables)}**: {', '.join(f'`{key}`' for key in keys)}")
        lines.append("")
    return lines
