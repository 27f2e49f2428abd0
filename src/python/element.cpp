// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "lab/results/reading.hpp"
#include "src/element/path_json.hpp"
#include "src/element/path_words.hpp"
#include "src/python/bindings.hpp"
#include "src/python/columns.hpp"
#include "src/python/documents.hpp"
#include "src/python/material.hpp"
#include "src/python/signals.hpp"
#include "src/study/element/run_element.hpp"

namespace triax::python {

namespace py = pybind11;

namespace {

struct ElementRun {
  explicit ElementRun(study::PathResult of) : result(std::move(of)) {}
  study::PathResult result;
  std::shared_ptr<Columns> rows = std::make_shared<Columns>();
};

void fill_rows(ElementRun& run) {
  for (std::size_t i = 0; i < run.result.columns.size(); ++i) {
    auto& values = run.rows->add(run.result.columns[i]);
    for (const study::ResultPoint& row : run.result.rows)
      values.push_back(i < row.values.size() ? row.values[i].value_or(lab::kMissing)
                                             : lab::kMissing);
  }
}

std::shared_ptr<ElementRun> element(const std::filesystem::path& path, const py::dict& sets,
                                    const std::shared_ptr<Material>& material) {
  const auto settings = key_values(sets);
  const auto given = material ? std::optional(material->set) : std::nullopt;
  const py::gil_scoped_release free;
  Signals signals;
  auto run = std::make_shared<ElementRun>(
      study::run_element(study::described_path(path.string(), settings, given),
                         [&](const std::string&, double) { signals.look(); }));
  fill_rows(*run);
  return run;
}

}  // namespace

void bind_element(py::module_& module) {
  py::class_<ElementRun, std::shared_ptr<ElementRun>>(module, "ElementRun",
                                                      "Result of the path of one material point.")
      .def_property_readonly(
          "name", [](const ElementRun& r) { return r.result.name; }, "Name of the path.")
      .def_property_readonly(
          "completed", [](const ElementRun& r) { return r.result.went_to_the_end(); },
          "True if the path reached its end. If not, `message` states why and where it stopped.")
      .def_property_readonly(
          "outcome", [](const ElementRun& r) { return src::word_of(r.result.outcome); },
          "'accepted', 'inaccurate', 'lost_control' or 'failed'.")
      .def_property_readonly(
          "message", [](const ElementRun& r) { return r.result.message; },
          "One sentence about the outcome, if it is not 'accepted'.")
      .def_property_readonly(
          "warnings", [](const ElementRun& r) { return r.result.warnings; },
          "Warnings that a reader of the result must know.")
      .def_property_readonly(
          "rows", [](const ElementRun& r) { return r.rows; },
          "All rows as columns: progress, strains, stresses, second-order work, memory.")
      .def_property_readonly(
          "segments",
          [](const ElementRun& r) {
            std::vector<std::string> names;
            for (const auto& row : r.result.rows) names.push_back(row.segment);
            return names;
          },
          "Name of the segment of each row.")
      .def_property_readonly(
          "report", [](const ElementRun& r) { return document(src::path_json(r.result)); },
          "Document of triax element --json: start, events, peak, last, rows.")
      .def("__repr__", [](const ElementRun& r) {
        return "<triax.ElementRun '" + r.result.name + "', " + src::word_of(r.result.outcome) +
               ", " + std::to_string(r.result.rows.size()) + " rows>";
      });
  module.def(
      "element", &element, py::arg("path"), py::kw_only(), py::arg("sets") = py::dict(),
      py::arg("material") = py::none(),
      "Run one material point along a path (as triax element).\n"
      "`path` is a path file: .toml, or files of incrementalDriver.\n"
      "`sets` changes material, void_ratio, p_eff_kPa, tolerance or a parameter of the law.\n"
      "`material` is a triax.Material that replaces the material of the file.");
}

}  // namespace triax::python
