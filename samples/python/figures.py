#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the stress paths, onsets and second-order work of two tests with matplotlib."""
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import triax

records = Path(__file__).parents[1] / "records"
figure, (paths, work) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
for record, colour in (("icu_6.csv", "tab:blue"), ("csd_58.csv", "tab:orange")):
    test = triax.replay(records / record, "tests.db")
    s, w, onset = test.states, test.second_order_work, test.report["collapse"]
    paths.plot(s.p_eff_kPa, s.q_kPa, color=colour, label=test.name)
    paths.plot(onset["p_eff_kPa"], onset["q_kPa"], "o", color=colour, label=f"onset, eta {onset['eta']:.3f}")
    work.plot(w.reading / w.reading[-1], w.normalised, color=colour, label=test.name)
paths.set(xlabel="p' (kPa)", ylabel="q (kPa)", xlim=(0, None))
work.set(xlabel="share of the readings", ylabel="normalised second-order work", ylim=(-1.05, 1.05))
work.axhline(0, color="grey", linewidth=0.8)
for axes in (paths, work):
    axes.legend(frameon=False)
figure.savefig("figures.png", dpi=150)
figure.savefig("figures.svg")
print("figures.png and figures.svg: 2 tests")
