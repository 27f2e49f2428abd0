// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What each file of this folder adds to the Python module, in the order in which module.cpp calls
// them: a type comes before what returns it.
#include <pybind11/pybind11.h>

namespace triax::python {

void bind_errors(pybind11::module_& module);
void bind_columns(pybind11::module_& module);
void bind_tests(pybind11::module_& module);
void bind_runs(pybind11::module_& module);
void bind_materials(pybind11::module_& module);
void bind_steps(pybind11::module_& module);
void bind_points(pybind11::module_& module);
void bind_element(pybind11::module_& module);
void bind_probe(pybind11::module_& module);
void bind_domain(pybind11::module_& module);
void bind_soil(pybind11::module_& module);
void bind_calibrate(pybind11::module_& module);

}  // namespace triax::python
