#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Assesses a recorded test: onset of instability, stress ratio and confidence interval."""
from pathlib import Path

import triax

records = Path(__file__).parents[1] / "records"
test = triax.replay(records / "icu_6.csv", "tests.db")
collapse = test.report["collapse"]
print(f"{test.name}: {collapse['kind']} from reading {collapse['reading']} on, {collapse['time_s']:.0f} s")
print(f"eta {collapse['eta']:.3f}, 95 % between {collapse['eta_low']:.3f} and {collapse['eta_high']:.3f}")
for criterion in collapse["criteria"]:
    found = f"reading {criterion['reading']}" if criterion["detected"] else "nothing"
    print(f"  {criterion['name']:<22} {found}")
