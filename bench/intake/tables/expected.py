# SPDX-License-Identifier: GPL-3.0-or-later
"""NAME.expected.toml: what a reader should make of a file."""
import json

IDENTITIES = [  # text, {quantity: coefficient}, the sum of which is constant
    ("q = σ1 - σ3", {"deviator_stress": 1, "axial_stress": -1, "radial_stress": 1}),
    ("q = σ1' - σ3'", {"deviator_stress": 1, "effective_axial_stress": -1, "effective_radial_stress": 1}),
    ("t = (σ1' - σ3')/2", {"half_deviator_stress": 2, "effective_axial_stress": -1, "effective_radial_stress": 1}),
    ("p' = σ3' + q/3", {"mean_effective_stress": 3, "effective_radial_stress": -3, "deviator_stress": -1}),
    ("s' = σ3' + t", {"mean_effective_stress_2d": 1, "effective_radial_stress": -1, "half_deviator_stress": -1}),
    ("q = 2 t", {"deviator_stress": 1, "half_deviator_stress": -2}),
    ("σ3 = σ3' + u", {"radial_stress": 1, "effective_radial_stress": -1, "pore_pressure": -1}),
    ("σ1 = σ1' + u", {"axial_stress": 1, "effective_axial_stress": -1, "pore_pressure": -1}),
    ("σ3 (cell) = σ3' + u", {"cell_pressure": 1, "effective_radial_stress": -1, "pore_pressure": -1}),
    ("p = p' + u", {"mean_stress": 1, "mean_effective_stress": -1, "pore_pressure": -1}),
    ("p' = σ3 (cell) - u + q/3", {"mean_effective_stress": 3, "cell_pressure": -3, "pore_pressure": 3, "deviator_stress": -1}),
    ("s' = σ3 (cell) - u + t", {"mean_effective_stress_2d": 1, "cell_pressure": -1, "pore_pressure": 1, "half_deviator_stress": -1}),
    ("εv = ε1 + 2 εr", {"volumetric_strain": 1, "axial_strain": -1, "radial_strain": -2}),
]


def value(x):
    if isinstance(x, bool):
        return "true" if x else "false"
    if isinstance(x, float):
        return repr(float(f"{x:.12g}"))
    if isinstance(x, (list, tuple, set)):
        return "[" + ", ".join(value(v) for v in x) + "]"
    return json.dumps(x, ensure_ascii=False) if isinstance(x, str) else str(x)


def table(name, pairs):
    return [f"\n{name}"] + [f"{k} = {value(v)}" for k, v in pairs.items()]


def half_unit(column):
    """Half of the last written place, in canonical units."""
    text = next((t for t in column.plain if t), "0")
    mantissa, _, _ = text.partition("E")
    decimals = len(mantissa.partition(".")[2])
    power = max(int(t.partition("E")[2] or 0) for t in column.plain)
    return 0.5 * 10 ** (power - decimals) * column.factor


def identities(columns):
    by = {c.quantity: c for c in columns if c.plain and not c.form and c.unit_source != "asked"}
    out = []
    for text, parts in IDENTITIES:
        if all(q in by for q in parts):
            scale = max(abs(f) for f in parts.values())
            within = sum(abs(f) * half_unit(by[q]) for q, f in parts.items()) / scale
            out.append({"holds": text, "within": float(f"{1.01 * within:.3g}")})
    return out


def document(head, labels, columns, traits):
    lines = ["# Written by bench/intake/make_tables.py. Units and values are given in s, mm, mm2, mm3, kN, kPa and plain numbers."]
    lines += [f"{k} = {value(v)}" for k, v in head.items()]
    if labels:
        lines += table("[labels]", labels)
    lines += table("[traits]", traits)
    for identity in identities([c for c, _ in columns if c.test in (0, 1)]):
        lines += table("[[identities]]", identity)
    for position, (column, described) in enumerate(columns, 1):
        lines += table("[[columns]]", {"position": position, **described})
    return "\n".join(lines) + "\n"
