#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Calibrates a law on tests, predicts each test from the others, and simulates a new test."""
from pathlib import Path

import triax

programme = Path(__file__).parents[1] / "programmes/icu_dense.toml"
sand = {"specimen.material": "sanisand/S28-general"}
tests = [triax.simulate(programme, "tests.db", sets=sand | {"specimen.void_ratio": e}).id for e in (0.92, 0.96, 1.0)]

found = triax.calibrate("tests.db", "sanisand", tests=tests, free=["critical_stress_ratio", "critical_void_ratio"], searches=1)
p = found.parameters
for name, value, low, high in zip(found.names, p.value, p.low, p.high):
    print(f"{name} {value:.3f}, 95 % between {low:.3f} and {high:.3f}")
for eta, predicted in zip(found.predictions.eta, found.predictions.predicted):
    print(f"eta at collapse {eta:.2f}, predicted from the others {predicted:.2f}")

found.write("my_sand.toml")
again = triax.simulate(programme, "tests.db", sets={"specimen.material_file": str(Path("my_sand.toml").absolute()),
                                                    "specimen.material": "sanisand/my_sand", "specimen.void_ratio": 0.94})
print(f"with them at e 0.94: largest q {again.report['peak']['q_kPa']:.0f} kPa")
