#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a material point along a path to instability, and under a load that it cannot carry."""
from pathlib import Path

import triax

paths = Path(__file__).parents[1] / "paths"
run = triax.element(paths / "icu_100.toml")
for event in run.report["events"]:
    print(f"{event['kind']}: q {event['at']['q_kPa']:.2f} kPa, eta {event['at']['eta']:.4f}")
print(f"largest q of {run.rows.rows} rows: {run.rows.q_kPa.max():.2f} kPa")

run = triax.element(paths / "load_beyond_limit.toml")
print(run.outcome + ": " + run.message)
