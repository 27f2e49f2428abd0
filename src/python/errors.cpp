// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/bad_input.hpp"
#include "src/python/bindings.hpp"

namespace triax::python {

namespace py = pybind11;

void bind_errors(py::module_& module) {
  py::register_exception<lab::BadInput>(module, "BadInput", PyExc_ValueError).attr("__doc__") =
      "Invalid input. The program prints the same message and ends with status 2.";
  py::register_exception<lab::WorkFailed>(module, "WorkFailed", PyExc_RuntimeError)
      .attr("__doc__") =
      "Failure during a run with valid input. The program prints the same message and ends with "
      "status 1.";
}

}  // namespace triax::python
