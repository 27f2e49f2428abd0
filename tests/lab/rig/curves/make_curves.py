#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Undrained curves in closed form, in the tables that other laboratories write: what records_of_closed_form_test.cpp replays.
They are no measurements. Nothing of triax goes into them: two functions of the axial strain e and a calculator are enough.

    eta = M e/(e + a)                 rises to M from the start
    q   = s e f(e),  p' = q/eta = (s/M) (e + a) f(e),  s = M p0'/a so that p' begins at p0'

    flow      f = exp(-e/c)                      q is greatest at e = c: s c/exp(1), at eta = M c/(c + a); dies away
    limited   f = exp(-e/c) + g (e/c)^2          the same, but strength comes back
    stable    f = 1/(1 + e/b)                    q rises for ever to s b

The cell pressure stays; u takes what p' leaves: u = cell + q/3 - p'.
Run it in its folder to write the tables anew: python3 make_curves.py
"""
from math import exp

M, A, C, B, G = 1.25, 0.006, 0.005, 0.004, 0.002
CELL = 600.0
STRAINS = [i * 0.0004 for i in range(26)] + [0.01 + i * 0.0025 for i in range(1, 17)]

SHAPES = {
    "flow": lambda e: exp(-e / C),
    "limited": lambda e: exp(-e / C) + G * (e / C) ** 2,
    "stable": lambda e: 1 / (1 + e / B),
}


def states(shape, p0):
    """(strain, q, p') at every strain, stresses in kPa."""
    s = M * p0 / A
    for e in STRAINS:
        yield e, s * e * SHAPES[shape](e), s / M * (e + A) * SHAPES[shape](e)


def karlsruhe(shape, p0):
    names = ["eps1", "sigma3", "sigma3'", "sigma1", "sigma1'", "u", "p", "q"]
    lines = ["   ".join(names), "[%]   " + "   ".join(["[kPa]"] * 7), ""]
    for e, q, p in states(shape, p0):
        u = CELL + q / 3 - p
        row = [100 * e, CELL, CELL - u, CELL + q, CELL + q - u, u, p, q]
        lines.append("\t".join([f"{row[0]:.4f}"] + [f"{value:.3f}" for value in row[1:]]))
    return "\n".join(lines) + "\n"


def timed(shape, p0):
    """A table with a clock: 0.1 % a minute."""
    lines = ["time_s,axial_strain_percent,deviator_stress_kPa,mean_effective_stress_kPa"]
    for e, q, p in states(shape, p0):
        lines.append(f"{60 * 1000 * e:.1f},{100 * e:.4f},{q:.3f},{p:.3f}")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    for shape in SHAPES:
        with open(f"{shape}.dat", "w", encoding="ascii") as file:
            file.write(karlsruhe(shape, 100.0))
    with open("flow_timed.csv", "w", encoding="ascii") as file:
        file.write(timed("flow", 200.0))
