# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of docs/tutorials/hand-calculation.md (tools/pages): five readings, by hand and by triax."""
import sys
from math import asin, degrees, hypot, isclose, pi, sqrt

from remade.program import indented

HEIGHT_MM, DIAMETER_MM, VOID_RATIO = 140, 70, 1.05
RECORD = f"""\
# [test]
# name = "Hand"
# programme = "CSD"
# [specimen]
# height_mm = {HEIGHT_MM}
# diameter_mm = {DIAMETER_MM}
# void_ratio = {VOID_RATIO}
# [[stages]]
# number = 1
# role = "shear"
# drainage = "open"
# control = "constant_q"
time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,pore_pressure_kPa,back_volume_mm3
0,0.000,0.3850,400,300,0
60,0.050,0.3850,400,310,80
120,0.150,0.3855,400,320,120
180,0.450,0.3865,400,330,20
240,1.400,0.3890,400,340,-400
"""
READINGS = [[float(cell) for cell in line.split(",")] for line in RECORD.splitlines()[-5:]]
AREA_MM2 = pi / 4 * DIAMETER_MM**2


def by_hand(reading: int) -> dict:
    """The equations of the page; strains as plain numbers, stresses in kPa."""
    _, displacement, force, cell, pore, volume = READINGS[reading]
    s = {"axial_strain": displacement / HEIGHT_MM, "volumetric_strain": -volume / (AREA_MM2 * HEIGHT_MM)}
    s["current_area_mm2"] = AREA_MM2 * (1 - s["volumetric_strain"]) / (1 - s["axial_strain"])
    s["void_ratio"] = VOID_RATIO - s["volumetric_strain"] * (1 + VOID_RATIO)
    s["q_kPa"] = 1e6 * force / s["current_area_mm2"]
    s["effective_radial_stress_kPa"] = cell - pore
    s["effective_axial_stress_kPa"] = cell - pore + s["q_kPa"]
    s["p_eff_kPa"] = cell - pore + s["q_kPa"] / 3
    s["eta"] = s["q_kPa"] / s["p_eff_kPa"]
    s["phi_mob_deg"] = degrees(asin(3 * s["eta"] / (6 + s["eta"])))
    s["shear_strain"] = s["axial_strain"] - s["volumetric_strain"] / 3
    s["radial_strain"] = (s["volumetric_strain"] - s["axial_strain"]) / 2
    return s


def states(triax) -> list[dict]:
    """Those of triax. Fails if one differs from that by hand."""
    (triax.folder / "hand.csv").write_text(RECORD, encoding="utf-8")
    triax.run("replay", "hand.csv", "--db", "hand.db")
    rows = triax.query("SELECT * FROM states ORDER BY reading", "--db", "hand.db")
    for row in rows:
        for name, value in by_hand(row["reading"]).items():
            if not isclose(row[name], value, rel_tol=1e-9, abs_tol=1e-12):
                sys.exit(f"reading {row['reading']}: {name} is {row[name]} in triax, {value} by hand")
    return rows


def record(_) -> str:
    lines = ["cat > hand.csv <<'END'", *RECORD.splitlines(), "END"]
    return "\n".join(f"    {line}" for line in lines)


def one_reading(triax) -> str:
    s = states(triax)[3]
    _, displacement, force, cell, pore, volume = READINGS[3]
    return f"""\
    ε₁   = {displacement:.3f}/{HEIGHT_MM} = {s['axial_strain']:.7f}
    ε_v  = −{volume:.0f}/{AREA_MM2 * HEIGHT_MM:.1f} = −{-s['volumetric_strain']:.7f}
    A    = {AREA_MM2:.2f} · (1 + {-s['volumetric_strain']:.7f})/(1 − {s['axial_strain']:.7f}) = {s['current_area_mm2']:.2f} mm²
    e    = {VOID_RATIO} + {-s['volumetric_strain']:.7f} · {1 + VOID_RATIO} = {s['void_ratio']:.5f}
    q    = {1e3 * force:.1f} N/{s['current_area_mm2']:.2f} mm² = {s['q_kPa']:.2f} kPa
    σ₃′  = {cell:.0f} − {pore:.0f} = {s['effective_radial_stress_kPa']:.0f} kPa
    σ₁′  = {s['effective_radial_stress_kPa']:.0f} + {s['q_kPa']:.2f} = {s['effective_axial_stress_kPa']:.2f} kPa
    p′   = {s['effective_radial_stress_kPa']:.0f} + {s['q_kPa']:.2f}/3 = {s['p_eff_kPa']:.2f} kPa
    η    = {s['q_kPa']:.2f}/{s['p_eff_kPa']:.2f} = {s['eta']:.4f}"""


def printed(triax, sql: str) -> str:
    states(triax)
    return indented(triax.run("query", sql, "--db", "hand.db"))


def reduced(triax) -> str:
    return printed(triax, "SELECT reading, axial_strain, volumetric_strain, current_area_mm2, void_ratio, q_kPa, p_eff_kPa, eta FROM states")


def increments(triax) -> list[dict]:
    rows = states(triax)
    names = ("q_kPa", "p_eff_kPa", "effective_axial_stress_kPa", "effective_radial_stress_kPa", "shear_strain", "volumetric_strain",
             "axial_strain", "radial_strain")
    return [{name: b[name] - a[name] for name in names} for a, b in zip(rows, rows[1:])]


def work_of(d: dict) -> float:
    """kPa, which is kJ/m³"""
    return d["q_kPa"] * d["shear_strain"] + d["p_eff_kPa"] * d["volumetric_strain"]


def one_increment(triax) -> str:
    d = increments(triax)[2]
    stress = hypot(d["effective_axial_stress_kPa"], sqrt(2) * d["effective_radial_stress_kPa"])
    strain = hypot(d["axial_strain"], sqrt(2) * d["radial_strain"])
    shear, volume = d["q_kPa"] * d["shear_strain"], d["p_eff_kPa"] * d["volumetric_strain"]
    axial = d["effective_axial_stress_kPa"] * d["axial_strain"]
    radial = 2 * d["effective_radial_stress_kPa"] * d["radial_strain"]
    return f"""\
    dε_q = {d['axial_strain']:.7f} − {d['volumetric_strain']:.7f}/3 = {d['shear_strain']:.7f}
    W2   = {d['q_kPa']:.4f} · {d['shear_strain']:.7f} − {-d['p_eff_kPa']:.4f} · {d['volumetric_strain']:.7f}
         = {1e3 * shear:.2f} − {-1e3 * volume:.2f} = −{-1e3 * work_of(d):.2f} J/m³
    W2   = dσ₁′ dε₁ + 2 dσ₃′ dε₃ = −{-1e3 * axial:.2f} + {1e3 * radial:.2f} = −{-1e3 * (axial + radial):.2f} J/m³
    W2 normalised = −{-work_of(d):.7f}/({stress:.3f} · {strain:.7f}) = −{-work_of(d) / (stress * strain):.3f}"""


def work(triax) -> str:
    """The query of the page. Fails if it differs from the work of the increments."""
    sql = """SELECT reading, 1000 * ((q_kPa - lag(q_kPa) OVER w) * (shear_strain - lag(shear_strain) OVER w)
        + (p_eff_kPa - lag(p_eff_kPa) OVER w) * (volumetric_strain - lag(volumetric_strain) OVER w)) AS W2_J_per_m3
        FROM states WINDOW w AS (ORDER BY reading)"""
    text = printed(triax, sql)
    for row, d in zip(triax.query(sql, "--db", "hand.db")[1:], increments(triax)):
        if not isclose(row["W2_J_per_m3"], 1e3 * work_of(d), rel_tol=1e-9):
            sys.exit(f"reading {row['reading']}: W2 is {row['W2_J_per_m3']} by the query, {1e3 * work_of(d)} by hand")
    return text
