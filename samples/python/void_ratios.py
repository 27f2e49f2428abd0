#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulates one programme at four void ratios and prints which specimens collapse."""
from pathlib import Path

import triax

programme = Path(__file__).parents[1] / "programmes/icu_dense.toml"
for void_ratio in (0.75, 0.85, 0.95, 1.05):
    test = triax.simulate(programme, "tests.db", sets={"specimen.void_ratio": void_ratio})
    peak, collapse = test.report["peak"], test.report["collapse"]
    print(f"e {void_ratio:.2f}: {collapse['kind']}, largest q {peak['q_kPa']:.1f} kPa at eta {peak['eta']:.3f}")
