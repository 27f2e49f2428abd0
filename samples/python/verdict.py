#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A recorded test: when it became unstable, at what stress ratio, and how sure that is."""
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
