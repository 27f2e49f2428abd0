# SPDX-License-Identifier: GPL-3.0-or-later
"""triax: triaxial tests on soil, simulated and recorded, and the onset of collapse by second-order work.

Compression is positive. Units are part of the names: q_kPa, time_s. A name without a unit is a plain number.
An unknown value is NaN in an array and None elsewhere. Input that the program rejects raises BadInput. A failure
while running raises WorkFailed. The messages are those of the program. Computations release the GIL. Ctrl-C stops
them within 0.1 s, but query stops between two rows, soil between two tests, and second_order_work after its points
are read. calibrate returns the best result so far as `best` of the exception.
"""
from ._triax import (DOMAIN_KINDS, OUTCOMES, BadInput, Calibration, Columns, Database, Domain, ElementRun, Material,
                     Points, ProbedState, ProbeRun, Soil, Steps, Test, WorkFailed, __version__, calibrate, domain,
                     element, materials, probe, replay, simulate, soil, soils)

__all__ = ["DOMAIN_KINDS", "OUTCOMES", "BadInput", "Calibration", "Columns", "Database", "Domain", "ElementRun",
           "Material", "Points", "ProbedState", "ProbeRun", "Soil", "Steps", "Test", "WorkFailed", "calibrate",
           "domain", "element", "materials", "probe", "replay", "simulate", "soil", "soils"]

for _name in __all__:  # as messages, help() and pickles name them
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = __name__
del _name
