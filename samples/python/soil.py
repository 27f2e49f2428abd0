#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimates the critical state line and M of a sand from four tests, and draws them."""
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import triax

programmes = Path(__file__).parents[1] / "programmes"
tests = [triax.simulate(programmes / programme, "tests.db", sets={
             "specimen.material": "sanisand/S28-general", "specimen.void_ratio": void_ratio,
             "rig.frame.travel_mm": 45, "stages.4.end.1.above": 25}).id
         for programme in ("icu_dense.toml", "control_drained_loose.toml") for void_ratio in (0.95, 1.0)]

sand = triax.soil("tests.db", tests=tests)
m = sand.report["friction"]["critical_stress_ratio"]
print(f"{sand.group}: M {m['value']:.2f}, 95 % between {m['low']:.2f} and {m['high']:.2f}")
states, line = sand.critical_states, sand.critical_line(np.geomspace(5, 600, 50))
for test, reached, p, e in zip(states.test, states.reached, states.p_eff_kPa, states.void_ratio):
    print(f"test {test}: p' {p:.0f} kPa, e {e:.3f}, {'reached' if reached else 'extrapolated'}")
sand.write("soil.toml")  # triax.calibrate can start from this file

figure, (plane, paths) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
plane.fill_between(line.p_eff_kPa, line.low, line.high, color="tab:blue", alpha=0.2, linewidth=0)
plane.plot(line.p_eff_kPa, line.void_ratio, color="tab:blue", label="critical state line, 95 %")
plane.errorbar(states.p_eff_kPa, states.void_ratio, states.void_ratio_error, states.p_eff_error_kPa, "o", color="black")
for test, path in zip(sand.tests.id, sand.paths):
    plane.plot(path.p_eff_kPa, path.void_ratio, linewidth=0.8, color="grey")
    paths.plot(path.p_eff_kPa, path.q_kPa, label=f"test {test}")
paths.axline((0, 0), slope=m["value"], color="black", linewidth=0.8, label="M")
plane.set(xscale="log", xlabel="p' (kPa)", ylabel="void ratio")
paths.set(xlabel="p' (kPa)", ylabel="q (kPa)", xlim=(0, None), ylim=(0, None))
for axes in (plane, paths):
    axes.legend(frameon=False)
figure.savefig("soil.png", dpi=150)
