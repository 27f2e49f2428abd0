#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A host program for a law: drained triaxial tests at constant cell pressure, with an unloading.
The program reads and writes the states in place, as arrays."""
import numpy as np
import triax

clay = triax.Material("cam_clay/Hostun-like")
cell_kPa = np.array([50.0, 100.0, 200.0])
points = triax.Points(clay, np.column_stack([cell_kPa, cell_kPa]), 0.9)
drained = ([[0, 0], [0, 1]], [[1, 0], [0, 0]])  # S, E: axial strain and constant radial stress
stress = points.stress_kPa  # refers to the states, no copy
for part, axial in (("loaded", 5e-4), ("unloaded", -2e-5), ("loaded again", 5e-4)):
    for _ in range(40):
        if not points.advance(control=drained, increment=[axial, 0]).accepted:
            raise SystemExit("not accepted")
    assert np.allclose(stress[:, 1], cell_kPa)
    print(f"{part + ':':<14}" + "  ".join(f"q {q:.2f} kPa" for q in stress[:, 0] - stress[:, 1]))
print("void ratio " + "  ".join(f"{e:.4f}" for e in points.void_ratio))
