#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the unstable directions at increasing stress ratios: a cone appears and opens."""
import numpy as np
import triax

run = triax.probe("inl2/S28-general", p_kPa=70, eta=np.arange(0.50, 0.72, 0.05), void_ratio=1.086)
for state in run.states:
    cones = ", ".join(f"{a:.1f} to {b:.1f}" for a, b in state.cones_deg) or "none"
    print(f"eta {state.eta:.2f}: least work {state.least:+.4f} at {state.least_deg:.1f} degrees; unstable: {cones}")
