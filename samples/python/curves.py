#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gets the peak, the remaining strength and the pore pressure ratio of a test from its arrays."""
from pathlib import Path

import numpy as np
import triax

records = Path(__file__).parents[1] / "records"
test = triax.replay(records / "icu_6.csv", "tests.db")
s = test.states
shear = s.stage == s.stage.max()
q, p, u, strain = (a[shear] for a in (s.q_kPa, s.p_eff_kPa, s.pore_pressure_kPa, s.axial_strain))
peak = int(np.argmax(q))
print(f"{s.rows} readings, {shear.sum()} of shear")
print(f"peak: q {q[peak]:.1f} kPa at {100 * strain[peak]:.2f} % of axial strain, eta {q[peak] / p[peak]:.3f}")
print(f"at the end: q {q[-1]:.1f} kPa, {100 * q[-1] / q[peak]:.0f} % of the peak; p' {p[-1]:.1f} kPa")
print(f"largest r_u {((u - u[0]) / p[0]).max():.2f}")
