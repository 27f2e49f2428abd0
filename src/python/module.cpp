// SPDX-License-Identifier: GPL-3.0-or-later
// The studies of src/study as the Python module triax._triax, which src/python/triax/__init__.py
// passes on.
#include <string>

#include "src/python/bindings.hpp"
#include "src/study/version.hpp"

PYBIND11_MODULE(_triax, module) {
  using namespace triax::python;
  module.attr("__version__") = std::string(triax::study::version());
  bind_errors(module);
  bind_columns(module);
  bind_tests(module);
  bind_runs(module);
  bind_materials(module);
  bind_steps(module);
  bind_points(module);
  bind_element(module);
  bind_probe(module);
  bind_domain(module);
  bind_soil(module);
  bind_calibrate(module);
}
