# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of docs/explanation/detection.md (tools/pages)."""
from math import sqrt


def stretches(_) -> str:
    axial, volumetric = 0.15, -0.03
    return (f"At ε₁ = {100 * axial:.0f} % and ε_v = −{-100 * volumetric:.0f} % λ₃ is {sqrt((1 - volumetric) / (1 - axial)):.3f}, where 1 − ε₃ would be "
            f"{1 - (volumetric - axial) / 2:.3f}.")


def least_delay(scatter: float, curvature: float, readings: int) -> float:
    return sqrt(1.5) * scatter / (curvature * readings**1.5)


def what_noise_allows(_) -> str:
    q_pa, noise_pa, to_the_peak = 100e3, 80, 200
    peak = 2 * q_pa / to_the_peak**2  # of q_pa - c t²/2, which is 0 at the start
    counted = 2 * 1 / 100**2  # mm³: 1 within 100 readings of the minimum
    return f"""\
An undrained test with q of {q_pa / 1e3:.0f} kPa, noise of {noise_pa} Pa and {to_the_peak} readings up to the peak (c = {peak:.0f} Pa a reading²) allows
{least_delay(noise_pa, peak, 50):.2f} reading over 50 readings on either side, a drained one whose volume passes its minimum by 1 mm³ in 100 readings, counted
in whole mm³, {least_delay(sqrt(1 / 12), counted, 200):.1f} over 200. So few readings of delay can be asked for, and what limits them is bias: a window that
reaches into the runaway is not a parabola."""


def slow_logger(triax) -> str:
    off = []
    for seed in (1, 2, 3):
        told = triax.documents("simulate", triax.sample("programmes/icu_load.toml"), "--seed", str(seed), "--set", "test.scan_interval_s=7.5")[0]
        off.append(told["collapse"]["eta"] - told["collapse"]["truth"]["eta"])
    return (f"With 7.5 s between readings η of ICU 6 under a growing load is off by {max(map(abs, off)):.3f} (the largest of three seeds): p′ ran on after\n"
            "the last reading.")
