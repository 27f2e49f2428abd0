# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of docs/how-to/calibrate.md (tools/pages)."""

import pathlib

from remade.benchmark import timed
from remade.others import of_others
from remade.program import indented

DRAINED = ("TMD1", "TMD3", "TMD5", "TMD8", "TMD10", "TMD13", "TMD16", "TMD18", "TMD21", "TMD24")
PUBLISHED = """law = "hypoplastic"
[sets.published]
critical_friction_angle_deg = 33.1
granulate_hardness_kPa = 4.0e6
pressure_exponent = 0.27
densest_void_ratio = 0.677
critical_void_ratio = 1.054
loosest_void_ratio = 1.212
peak_exponent = 0.14
stiffness_exponent = 2.5
"""
FREE = "critical_stress_ratio,critical_void_ratio,hardening_factor,dilatancy_factor"
LIMITS = ("--fix", "densest_void_ratio", "--fix", "critical_void_ratio", "--fix", "loosest_void_ratio")


def domain(triax) -> str:
    """What four simulated tests of a sand leave open of its cones and its domain."""
    for programme in ("icu_dense", "control_drained_loose"):
        for void_ratio in ("0.95", "1.0"):
            triax.run("simulate", f"samples/programmes/{programme}.toml", "--db", "sand.db", "--set", "specimen.material=sanisand/S28-general",
                      "--set", f"specimen.void_ratio={void_ratio}", "--set", "rig.frame.travel_mm=45", "--set", "stages.4.end.1.above=25")
    told = triax.run("calibrate", "sanisand", "--db", "sand.db", "--free", FREE, "--searches", "1")
    lines = told.splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("Cones and domain"))
    return f"Two undrained and two drained tests of SANISAND itself with the noise of instruments, `--free {FREE}`:\n\n{indented(chr(10).join(lines[first:]))}"


def coverage(triax) -> str:
    return timed(triax, "bench/calibrate/run.sh coverage --sets 40")


def left_out(triax) -> str:
    return timed(triax, "bench/calibrate/run.sh left-out --sets 10")


def costs(triax, folder: pathlib.Path) -> str:
    """Costs of laws on Karlsruhe fine sand."""
    (triax.folder / "published.toml").write_text(PUBLISHED, encoding="utf-8")
    for name in DRAINED:
        triax.run("replay", str(folder / f"kfs/{name}.dat"), "--db", "kfs.db")
    triax.run("replay", str(folder / "kfs/TMU1.dat"), "--db", "kfs.db", "--set", "specimen.void_ratio=0.828")
    rows = ["| law | free | cost | searches at the best | not determined |", "|---|---|---|---|---|"]
    for words, law, options in (("hypoplastic", "hypoplastic", ("--start", "published.toml")),
                                ("hypoplastic, void ratios at p' = 0 as published", "hypoplastic", ("--start", "published.toml", *LIMITS)),
                                ("NorSand", "norsand", ()), ("SANISAND", "sanisand", ("--searches", "2"))):
        told = triax.documents("calibrate", law, "--db", "kfs.db", *options)[0]
        if not rows[2:]:
            rows.append(f"| hypoplastic, the published set | 0 | {told['start_cost']:.1f} | | |")
        open_ones = [p["name"] for p in told["parameters"] if not p["determined"]]
        rows.append(f"| {words} | {len(told['parameters'])} | {told['cost']:.1f} | {told['searches']['at_the_best']} of {told['searches']['run']} | "
                    f"{', '.join(f'`{name}`' for name in open_ones) or 'none'} |")
    return "\n".join(rows)


def karlsruhe(triax) -> str:
    return of_others(triax, "calibrate", costs)
