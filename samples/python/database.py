#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists the tests of a database and runs an SQL query."""
from pathlib import Path

import triax

samples = Path(__file__).parents[1]
for record in ("icu_6.csv", "csd_58.csv"):
    triax.replay(samples / "records" / record, "tests.db")

database = triax.Database("tests.db")
for test in database:
    print(test.id, test.name, test.origin, test.status)
latest = database["ICU 6"]
rows = database.query(f"""SELECT stage, count(*) AS readings, max(pore_pressure_kPa) AS u_kPa
                          FROM readings WHERE test_id = {latest.id} GROUP BY stage""")
for row in rows:
    print(f"stage {row['stage']}: {row['readings']} readings, u up to {row['u_kPa']:.1f} kPa")
