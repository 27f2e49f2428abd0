# SPDX-License-Identifier: GPL-3.0-or-later
"""The JSON documents of triax, described from samples of them: as JSON Schema and as a page."""
import json
import re

from remade.program import Triax

# Document, commands whose output has its form. Each command runs in the same folder, in this order.
DOCUMENTS = {
    "test": ["simulate samples/programmes/icu_6.toml", "replay samples/records/csd_58.csv", "simulate samples/programmes/csu_26.toml",
             "simulate samples/programmes/control_drained_loose.toml", "simulate samples/programmes/perturbed.toml", "report 1 2 3 4"],
    "tests": ["tests list", "tests set 2 labels.client=A"],
    "tests-show": ["tests show 1", "tests show 2"],
    "element": ["element samples/paths/icu_100.toml", "element samples/paths/cyclic.toml", "element samples/paths/load_beyond_limit.toml"],
    "materials": ["materials", "materials inl2/S28-general"],
    "probe": ["probe --material inl2/S28-general --p-kPa 70 --eta 0.5,0.6 --void-ratio 1.086",
              "probe --path samples/paths/icu_100.toml --every 50"],
    "domain": ["domain --material inl2/S28-general --void-ratio 1.086 --p-kPa 20:200/4 --q-kPa 0:240/7"],
    "soil": ["soil"],
}
TITLES = {"test": "triax simulate, replay and report", "tests": "triax tests (each test)", "tests-show": "triax tests show"}
UNIT = re.compile(r"_(kPa|Pa|s|min|mm|mm2|mm3|ml|g|deg|J|N|kN|pct|percent|per_.*)$")
NAMES = {dict: "object", list: "array", str: "string", bool: "boolean", int: "integer", float: "number", type(None): "null"}


def merge(schema: dict, value, key: str = "") -> None:
    """Adds a value to the schema of all values in the same place."""
    name = NAMES[type(value)]
    if name == "integer" and UNIT.search(key):
        name = "number"
    types = schema.setdefault("type", [])
    if name not in types:
        types.append(name)
    if {"integer", "number"} <= set(types):
        types.remove("integer")
    if isinstance(value, dict):
        fields = schema.setdefault("properties", {})
        for field, inner in value.items():
            merge(fields.setdefault(field, {}), inner, field)
    elif isinstance(value, list):
        for inner in value:
            merge(schema.setdefault("items", {}), inner, key)


def finished(schema: dict) -> dict:
    """As JSON Schema. Other tests than the samples can leave any value unknown, which is null, and any member out."""
    out: dict = {}
    types = sorted(name for name in schema.get("type", []) if name != "null")
    if types:
        out["type"] = [*types, "null"]
    if "properties" in schema:
        out["properties"] = {key: finished(inner) for key, inner in schema["properties"].items()}
    if "items" in schema:
        out["items"] = finished(schema["items"])
    return out


def described(triax: Triax) -> dict[str, dict]:
    """The types of each document."""
    found = {}
    for name, commands in DOCUMENTS.items():
        schema: dict = {}
        for command in commands:
            document = json.loads(triax.run(*command.split(), "--json", may_fail=True))
            for one in document if isinstance(document, list) else [document]:
                merge(schema, one)
        found[name] = schema
    return found


def schema_document(name: str, schema: dict) -> dict:
    title = TITLES.get(name, f"triax {name}")
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": title, **finished(schema), "type": "object"}


def lines_of(schema: dict, path: str) -> list[str]:
    """One bullet for each object, with the types of its plain fields."""
    lines: list[str] = []
    if "items" in schema:
        lines += lines_of(schema["items"], path + "[]")
    fields = schema.get("properties", {})
    plain = [f"`{name}` {shown(inner)}" for name, inner in fields.items() if not nested(inner)]
    if plain:
        lines.append(f"- **`{path or 'document'}`**: {', '.join(plain)}")
    for name, inner in fields.items():
        lines += lines_of(inner, f"{path}.{name}" if path else name)
    return lines


def nested(schema: dict) -> bool:
    """True if an object is in it."""
    return "properties" in schema or ("items" in schema and nested(schema["items"]))


def shown(schema: dict) -> str:
    if "items" in schema:
        return f"array of {shown(schema['items'])}"
    types = sorted(schema.get("type", []), key=lambda name: (name == "null", name))
    return "null or a value" if types == ["null"] else " or ".join(types)


def json_page(found: dict[str, dict]) -> list[str]:
    lines = ["# JSON output", "", "The fields of the documents that commands print with `--json`, as found in the output for the samples. A suffix",
             "of a name is its unit. A field is `null` if its value is unknown. `[]` marks the elements of a list. A command that",
             "prints several tests prints a list of such documents. The folder [schemas](schemas) has the same as JSON Schema.", ""]
    for name, schema in found.items():
        lines += [f"## {TITLES.get(name, f'triax {name}')}", "", *lines_of(schema, ""), ""]
    return lines
