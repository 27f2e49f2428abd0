# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of docs/how-to/material-point.md (tools/pages)."""
import textwrap
from math import sqrt

# Table 2 of the paper: type, p'0 (kPa), e0, η at collapse.
TESTS = (("ICU", 100, 1.086, .58), ("ICU", 300, 1.060, .59), ("ICU", 750, 1.083, .56), ("CSD", 100, 1.192, .57),
         ("CSD", 300, 1.068, .55), ("CSD", 300, 1.161, .62), ("CSU", 100, 1.136, .52), ("CSU", 300, 1.070, .56),
         ("CSU", 300, 1.101, .51), ("CSU", 750, 1.136, .58))
START = """[path]
name = "collapse"
material = "inl2/S28-general"
[start]
p_eff_kPa = {p}
void_ratio = {e}
"""
UNDRAINED = """[[segments]]
name = "compression"
drainage = "undrained"
conditions = ["axial_strain = 0.05", "radial_stress_kPa = 0"]
"""
CONSTANT_SHEAR = """[[segments]]
name = "shear"
drainage = "drained"
conditions = ["axial_strain = 0.05", "radial_stress_kPa = 0"]
end = [{{quantity = "q_kPa", above = {q}}}]
[[segments]]
name = "constant q"
drainage = "drained"
conditions = ["q_kPa = 0", "p_kPa = {fall}"]
"""


def collapse(triax, p: float, e: float, segments: str) -> float:
    """η where the path loses second-order work."""
    path = triax.folder / f"{p}_{e}_{len(segments)}.toml"
    path.write_text(START.format(p=p, e=e) + segments.format(q=0.3 * p, fall=-0.8 * p), encoding="utf-8")
    told = triax.documents("element", str(path), may_fail=True)[0]
    return next(event["at"]["eta"] for event in told["events"] if event["kind"] == "second_order_work")


def table2(triax) -> str:
    found, apart = [], []
    for kind, p, e, measured in TESTS:
        undrained, sheared = (collapse(triax, p, e, segments) for segments in (UNDRAINED, CONSTANT_SHEAR))
        found.append((sheared if kind == "CSD" else undrained, measured))
        apart.append(abs(sheared - undrained))
    etas, measured = zip(*found)
    mean = sum(measured) / len(measured)

    def rms(differences):
        return sqrt(sum(d * d for d in differences) / len(measured))

    return textwrap.fill(f"""\
With the set `S28-general` INL2 gives the collapse of the ten tests of Table 2 at η = {min(etas):.2f} to {max(etas):.2f}. Measured
were {min(measured):.2f} to {max(measured):.2f}. The rms difference is {rms([a - b for a, b in found]):.3f}; a constant value gives at least {rms([m - mean for m in measured]):.3f}.
Undrained and constant-q paths differ by at most {max(apart):.3f}: one instability line, as in the paper. These are
paths of a material point. [Table 2](../explanation/paper.md) has the tests in the apparatus.""", 100)
