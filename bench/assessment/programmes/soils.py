# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws with their parameter sets (lab/materials), each parameter changed by up to 10 %, and the state of the specimen."""
import math
import pathlib
import tomllib

from .draws import cell, log_uniform, rounded, weighted

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "lab/materials"
LAWS = {"sanisand": 24, "inl2": 18, "hypoplastic": 22, "octolinear": 8, "norsand": 8, "cam_clay": 7, "mohr_coulomb": 6, "drucker_prager": 5,
        "elastic": 2}
MAX_CHANGE = 0.10
# Not properties of the soil, or bounds between which the law is not valid when changed alone.
KEPT = {"atmospheric_pressure_kPa", "reference_pressure_kPa", "shear_modulus_pressure_kPa", "critical_pressure_kPa", "intergranular_start",
        "pore_fluid_bulk_modulus_kPa", "overconsolidation_ratio", "largest_state_parameter", "extension_ratio", "hyperelastic"}
# One factor for all void ratios of a soil: their order is part of the law.
VOID_RATIOS = {"densest_void_ratio", "critical_void_ratio", "loosest_void_ratio"}
MAX_HARDENING = 0.97      # of c_h e: at 1 the hardening vanishes
USUAL_VOID_RATIOS = [0.5, 1.1]  # of laws that do not depend on the void ratio
# Laws that cannot be sheared on every path: norsand has no instability at constant q and no extension; a cone has no extension limit.
CONTROLS = {"norsand": ("displacement", "load", "spring", "drained", "dead_load"),
            "drucker_prager": ("displacement", "load", "spring", "drained", "dead_load", "csd", "csu", "strain_path", "cyclic"),
            "elastic": ("displacement", "load", "drained")}


def sets_of(law):
    with open(FOLDER / f"{law}.toml", "rb") as file:
        return tomllib.load(file)["sets"]


def changed(random, values):
    """The set with each number changed; void ratios and their range by one factor."""
    volume = random.uniform(1 - MAX_CHANGE, 1 + MAX_CHANGE)
    out = {}
    for key, value in values.items():
        if key in VOID_RATIOS:
            out[key] = rounded(value * volume, 5)
        elif key == "void_ratio_range":
            out[key] = [rounded(v * volume) for v in value]
        elif isinstance(value, float) and key not in KEPT:
            out[key] = rounded(value * random.uniform(1 - MAX_CHANGE, 1 + MAX_CHANGE), 5)
        else:
            out[key] = value
    if "overconsolidation_ratio" in values and random.random() < 0.5:
        out["overconsolidation_ratio"] = rounded(log_uniform(random, 1.0, 4.0), 3)
    return out


def critical_void_ratio(soil, p):
    if "critical_exponent" in soil:
        return soil["critical_void_ratio"] - soil["critical_slope"] * (p / 100) ** soil["critical_exponent"]
    return soil["critical_void_ratio"] - soil["critical_slope"] * math.log(p)


def void_ratio(random, law, soil, p):
    """Loose more often than dense: most of the instabilities are there."""
    if law == "norsand":
        return critical_void_ratio(soil, p) + random.uniform(-0.05, 0.16)
    low, high = soil.get("void_ratio_range", USUAL_VOID_RATIOS)
    low = max(low, 0.4)
    if "hardening_void_ratio_factor" in soil:
        high = min(high, MAX_HARDENING / soil["hardening_void_ratio_factor"])
    return high - (high - low) * random.random() ** 1.6 if random.random() < 0.7 else random.uniform(low, high)


def draw_soil(random, p, control, drained):
    """(name of the law, name of the set it comes from, its parameters, void ratio) for a test at p (kPa)."""
    law = weighted(random, {k: v for k, v in LAWS.items() if control in CONTROLS.get(k, (control,))})
    sets = sets_of(law)
    names = [name for name in sets if law != "norsand" or (sets[name]["pore_fluid_bulk_modulus_kPa"] == 0) == drained]
    name = random.choice(names)
    soil = changed(random, sets[name])
    return law, name, soil, rounded(void_ratio(random, law, soil, p))


STIFFNESS_KPA = 4.4e3    # of loose sand in isotropic loading at 20 kPa, growing with the root of p'
DISSOLVED = 0.018         # what dissolving air adds to the air in the pores
ATMOSPHERE_KPA = 100.0


def draw_fluid(random, p, back, volume, void_ratio):
    """(saturation, compliance of the lines in mm3/kPa) for a B at p (kPa) between about 0.6 and 1. volume: of the specimen, mm3."""
    wanted = random.uniform(0.97, 0.999) if random.random() < 0.5 else random.uniform(0.66, 0.97)
    per_kpa = (1 / wanted - 1) / (STIFFNESS_KPA * math.sqrt(p / 20))
    lines = min(log_uniform(random, 0.05, 5.0), per_kpa * volume)
    air = (per_kpa - lines / volume) * (back + ATMOSPHERE_KPA) * (1 + void_ratio) / void_ratio - DISSOLVED
    return rounded(1 - min(0.1, max(0.0, air))), rounded(lines, 2)


def material_file(law, name, soil):
    """The text of a file of parameter sets with this one set."""
    kept = {k: v for k, v in soil.items() if k not in ("description", "source", "range")}
    lines = [f'law = "{law}"', "", "[sets.drawn]", f'description = "{law}/{name}, parameters changed by up to 10 %"',
             'source = "drawn at random; no soil"', 'range = "none"']
    return "\n".join(lines + [f"{key} = {cell(value)}" for key, value in kept.items()]) + "\n"
