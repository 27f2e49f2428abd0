// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <algorithm>

#include "src/python/bindings.hpp"
#include "src/python/columns.hpp"
#include "src/python/points.hpp"

namespace triax::python {

namespace py = pybind11;

namespace {

using Member = std::vector<double> study::StepArrays::*;

/// A property of Steps: an array of a number a point, or of a row a point.
auto of_steps(Member member, bool row) {
  return [member, row](const py::object& self) {
    const auto& steps = self.cast<const Steps&>();
    return read_only_view(
        steps.arrays.*member, self,
        row ? shape(steps.arrays.done.size(), steps.components) : std::vector<py::ssize_t>());
  };
}

}  // namespace

void bind_steps(py::module_& module) {
  module.attr("OUTCOMES") = py::make_tuple("accepted", "inaccurate", "lost_control", "failed");
  py::class_<Steps, std::shared_ptr<Steps>>(module, "Steps",
                                            "Result of one increment for each point.")
      .def_property_readonly(
          "outcome",
          [](const py::object& self) {
            return read_only_view(self.cast<const Steps&>().arrays.outcome, self);
          },
          "Index into triax.OUTCOMES for each point.")
      .def_property_readonly(
          "accepted",
          [](const Steps& s) {
            return std::ranges::all_of(s.arrays.outcome,
                                       [](std::uint8_t outcome) { return outcome == 0; });
          },
          "True if every point completed its increment within the tolerance.")
      .def_property_readonly(
          "done", of_steps(&study::StepArrays::done, false),
          "Completed fraction of the increment; less than 1 if control was lost or the law failed.")
      .def_property_readonly("error", of_steps(&study::StepArrays::error, false),
                             "Largest estimated relative error.")
      .def_property_readonly(
          "stress_kPa", of_steps(&study::StepArrays::stress_kPa, true),
          "Increments of effective stress over the completed part, kPa, one row per point.")
      .def_property_readonly("strain", of_steps(&study::StepArrays::strain, true),
                             "Increments of strain over the completed part, one row per point.")
      .def_property_readonly("work_kPa", of_steps(&study::StepArrays::work_kPa, false),
                             "Second-order work of the completed part, kPa.")
      .def_property_readonly(
          "work_normalised", of_steps(&study::StepArrays::work_normalised, false),
          "Second-order work divided by the norms of both increments, in [-1, 1].")
      .def_property_readonly(
          "messages",
          [](const Steps& s) {
            py::dict all;
            for (const auto& [place, text] : s.arrays.messages) all[py::int_(place)] = text;
            return all;
          },
          "Reasons by index of the point, for the first hundred points that were not accepted.");
}

}  // namespace triax::python
