# SPDX-License-Identifier: GPL-3.0-or-later
"""triax: triaxial tests on soil, simulated and recorded, and the onset of collapse by second-order work.

Compression is positive. Units are in the names: q_kPa, time_s; a name without one is a plain number. What is unknown is
NaN in an array and None elsewhere. What the program would refuse raises BadInput, what fails on the way WorkFailed, with
the program's own words. Nothing holds the GIL while it computes; Ctrl-C is heeded within a tenth of a second,
of query between two rows, of soil between two tests; calibrate comes to the best so far first.
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
