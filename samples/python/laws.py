#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shears SANISAND undrained at 500 void ratios at once, and prints the loss of strength."""
import numpy as np
import triax

sand = triax.Material("sanisand/S28-general")
e = np.linspace(0.85, 1.05, 500)
points = triax.Points(sand, np.full((e.size, 2), 100.0), e)
undrained = (np.zeros((2, 2)), [[1, 0], [1, 2]])  # S, E: axial strain and constant volume
peak = np.zeros(e.size)
for _ in range(200):
    step = points.advance(control=undrained, increment=[5e-4, 0], tolerance=1e-6)
    np.maximum(peak, points.q_kPa, out=peak)
left = points.q_kPa / peak
for i in range(0, e.size, 99):
    print(f"e {e[i]:.3f}: peak q {peak[i]:.1f} kPa, {100 * left[i]:.0f} % of it left at 10 % of axial strain")
lost = e[left < 0.9]
print(f"more than a tenth is lost from e {lost.min():.3f} on" if lost.size else "none loses a tenth of its peak")
