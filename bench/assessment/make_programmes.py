#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_programmes.py --seed N --count M --out FOLDER

Writes M random test programmes of the apparatus, N_0001.toml and so on, each with its parameter set (N_0001.material.toml) and the same
programme on ideal instruments (N_0001.ideal.toml), and the list index.csv of what was drawn. A programme depends on the seed and on its
number only. Drawn are: law and parameter set, each parameter changed by up to 10 %; p'0 log-uniform from 20 to 1500 kPa; void ratio within
the range of the set; control; B by saturation and compliance; membrane; order of stages; changes of rate, rests, loops; anisotropic
consolidation; extension; noise, converters, lag and intervals of the instruments from good to terrible.
Seeds below 1000 are for development. Published results use seeds from 1000 on.
"""
import argparse
import copy
import csv
import math
import pathlib
import random as randomness
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from programmes import instruments, soils, stages  # noqa: E402
from programmes.draws import log_uniform, rounded, table, weighted  # noqa: E402

CONTROLS = {"displacement": 18, "load": 13, "spring": 6, "drained": 9, "dead_load": 6, "csd": 13, "csu": 12, "strain_path": 7, "cyclic": 9,
            "mixed": 7}
SIZES = ((140, 70), (100, 50), (76, 38), (200, 100), (71, 35.5), (150, 75))
COLUMNS = ["number", "control", "law", "set", "p0_kPa", "void_ratio", "saturation", "membrane", "extension", "consolidation_ratio", "quality",
           "scan_interval_s", "height_mm", "features"]
TYPES = {"csd": "CSD", "csu": "CSU", "drained": "CID", "strain_path": "SP", "cyclic": "CYC"}


def draw_specimen(random, control, p0):
    height, diameter = random.choice(SIZES)
    law, name, soil, void_ratio = soils.draw_soil(random, p0, control, control == "drained")
    test = stages.Test(random, p0, rounded(min(p0, log_uniform(random, 8, 40), 0.7 * p0), 2),
                       float(round(log_uniform(random, 100, 600), -1)), float(height), float(diameter))
    test.consolidated = law != "norsand"  # the law refuses isotropic loading
    simple = law in ("norsand", "elastic", "drucker_prager")
    if test.consolidated and not simple and control != "strain_path" and random.random() < 0.2:
        test.ratio = rounded(random.uniform(0.1, 0.6), 2)
    test.b_check = weighted(random, {"before": 75, "after": 0 if test.ratio else 10, "none": 15})
    test.extension = not simple and not test.ratio and control in ("displacement", "load", "csd", "csu", "drained") and random.random() < 0.15
    values = {"material": f"{law}/drawn", "material_file": "", "height_mm": test.height, "diameter_mm": test.diameter,
              "void_ratio": void_ratio, "specific_gravity": 2.65,
              "initial_effective_stress_kPa": test.start if test.consolidated else p0, "saturation": 1.0}
    compliance = None
    if "pore_fluid_bulk_modulus_kPa" not in soil or soil["pore_fluid_bulk_modulus_kPa"] == 0:
        volume = math.pi / 4 * test.diameter ** 2 * test.height
        values["saturation"], compliance = soils.draw_fluid(random, p0 if test.b_check == "after" else test.start, test.back, volume, void_ratio)
    if random.random() < 0.3:
        values |= {"membrane_thickness_mm": rounded(random.uniform(0.2, 0.6), 2), "membrane_modulus_kPa": rounded(random.uniform(800, 1600), 3)}
    if random.random() < 0.15 and compliance is not None:
        values["membrane_penetration_mm3_per_mm2"] = rounded(log_uniform(random, 0.002, 0.03), 2)
    return test, law, name, soil, values, compliance


def draw_programme(seed, number):
    """(row of the index, tables of the programme, text of the material file)."""
    random = randomness.Random(f"{seed}/{number}")
    control = weighted(random, CONTROLS)
    p0 = rounded(log_uniform(random, 20, 1500), 3)
    quality = rounded(random.random(), 3)
    test, law, name, soil, specimen, compliance = draw_specimen(random, control, p0)
    listed = stages.preparation(test) + stages.SHEAR[control](test)
    listed = stages.set_scans(test, listed)
    scan = rounded(log_uniform(random, 1, 20), 2)
    drained = any(s["role"] == "shear" and s["drainage"] == "open" for s in listed)
    rig, frame, controller = instruments.rig(random, quality, test.back, compliance, drained)
    largest = {"pressure": test.back + p0 + 80, "force": test.max_q * 1.2 * test.newton_per_kpa}
    frame["travel_mm"] = rounded(0.3 * test.height, 3)
    parts = {"test": {"name": f"{seed}_{number:04d}", "type": TYPES.get(control, "ICU"), "seed": random.randrange(1, 10 ** 6),
                      "scan_interval_s": scan},
             "specimen": specimen, "rig": rig, "rig.frame": frame, "rig.cell_controller": controller, "rig.back_controller": dict(controller)}
    for channel, values in instruments.transducers(random, quality, (test.height, test.diameter), largest).items():
        parts[f"rig.transducers.{channel}"] = values
    row = dict(zip(COLUMNS, [number, control, law, name, p0, specimen["void_ratio"], specimen["saturation"],
                             int("membrane_thickness_mm" in specimen), int(test.extension), test.ratio, quality,
                             next(s["scan_interval_s"] for s in listed if s["role"] == "shear"), test.height, "; ".join(test.features)]))
    return row, parts, listed, soils.material_file(law, name, soil)


def ideal(parts, listed):
    """The same specimen and stages on ideal instruments: what the truth is without the hunting of a coarse servo."""
    parts = {k: v for k, v in copy.deepcopy(parts).items() if not k.startswith("rig.transducers") and not k.endswith("_controller")}
    for key in ("velocity_step_mm_per_min", "servo_filter_s", "bandwidth_Hz"):
        parts["rig.frame"].pop(key, None)
    return parts, [{k: v for k, v in one.items() if k != "averaging_s"} for one in listed]


def text_of(parts, listed, heading):
    out = f"# {heading}\n\n"
    for name, values in parts.items():
        if values:
            out += table(f"[{name}]", values)
    return out + "".join(table("[[stages]]", one) for one in listed)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1, metavar="N")
    parser.add_argument("--count", type=int, default=20, metavar="M")
    parser.add_argument("--out", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("--only", type=int, action="append", default=[], metavar="NUMBER", help="only these programmes (repeatable)")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    rows = []
    for number in options.only or range(1, options.count + 1):
        row, parts, listed, material = draw_programme(options.seed, number)
        name = f"{options.seed}_{number:04d}"
        parts["specimen"]["material_file"] = f"{name}.material.toml"
        heading = f"Drawn by bench/assessment/make_programmes.py: seed {options.seed}, number {number}, {row['control']}"
        (options.out / f"{name}.material.toml").write_text(material, encoding="utf-8")
        (options.out / f"{name}.toml").write_text(text_of(parts, listed, heading), encoding="utf-8")
        (options.out / f"{name}.ideal.toml").write_text(text_of(*ideal(parts, listed), heading + ", ideal instruments"), encoding="utf-8")
        rows.append(row)
    with open(options.out / "index.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
