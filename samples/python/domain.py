#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the stress ratio from which a loose sand has unstable directions (bifurcation domain)."""
import numpy as np
import triax

domain = triax.domain("inl2/S28-general", 1.086, p_kPa=(50, 300, 6), q_kPa=(0, 350, 15), directions=72)
counts = np.bincount(domain.kind.ravel(), minlength=len(triax.DOMAIN_KINDS))
print(", ".join(f"{n} {kind}" for n, kind in zip(counts, triax.DOMAIN_KINDS) if n))
first, limit = domain.boundary("first_unstable"), domain.boundary("limit")
for p, eta, at_limit in zip(first.p_eff_kPa, first.eta, limit.eta):
    print(f"p' {p:.0f} kPa: unstable from eta {eta:.4f} on, limit {at_limit:.4f}")
