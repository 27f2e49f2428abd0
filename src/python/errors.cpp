// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/bad_input.hpp"
#include "src/python/bindings.hpp"

namespace triax::python {

namespace py = pybind11;

void bind_errors(py::module_& module) {
  py::register_exception<lab::BadInput>(module, "BadInput", PyExc_ValueError).attr("__doc__") =
      "Input that cannot be understood: what the program ends with status 2 for, in the same "
      "words.";
  py::register_exception<lab::WorkFailed>(module, "WorkFailed", PyExc_RuntimeError)
      .attr("__doc__") =
      "Work that was understood but failed on the way: status 1 of the program, in the same words.";
}

}  // namespace triax::python
