// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>

#include "src/python/bindings.hpp"
#include "src/python/documents.hpp"
#include "src/python/ranges.hpp"
#include "src/python/signals.hpp"
#include "src/python/soil_tables.hpp"
#include "src/python/warnings.hpp"
#include "src/study/soil/soil_choice.hpp"
#include "src/study/soil/soil_json.hpp"

namespace triax::python {

namespace py = pybind11;

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Path = std::filesystem::path;

struct Soil {
  explicit Soil(study::Soil of)
      : soil(std::move(of)),
        tests(std::make_shared<Columns>(table_of_tests(soil))),
        critical_states(std::make_shared<Columns>(table_of_critical_states(soil))),
        circles(std::make_shared<Columns>(table_of_circles(soil))) {
    for (const auto& test : soil.tests)
      paths.push_back(std::make_shared<Columns>(table_of_path(test)));
  }
  study::Soil soil;
  std::shared_ptr<Columns> tests, critical_states, circles;
  std::vector<std::shared_ptr<Columns>> paths;
};

study::SoilOptions options_of(const std::string& criterion, double failure_strain,
                              std::optional<double> exponent, double stress_error_kPa,
                              bool keep_odd) {
  must_lie("failure_strain", failure_strain, 0.001, 0.5);
  if (exponent) must_lie("exponent", *exponent, 0.01, 3);
  must_lie("stress_error_kPa", stress_error_kPa, 0, 100);
  return {.criterion = study::failure_criterion(criterion),
          .failure_strain = failure_strain,
          .exponent = exponent,
          .stress_error_kPa = stress_error_kPa,
          .keep_odd = keep_odd};
}

std::vector<std::shared_ptr<Soil>> studied(const study::SoilChoice& choice,
                                           const study::SoilOptions& options) {
  const py::gil_scoped_release free;
  warn_of_missing_readings(choice.db);
  Signals signals;
  std::vector<std::shared_ptr<Soil>> soils;
  for (auto& soil : study::study_soils(choice, options, [&] { signals.look(); }))
    soils.push_back(std::make_shared<Soil>(std::move(soil)));
  return soils;
}

std::shared_ptr<Soil> soil(const Path& db, const TestNames& tests, const std::string& where,
                           const std::string& criterion, double failure_strain,
                           std::optional<double> exponent, double stress_error_kPa, bool keep_odd) {
  return studied({.tests = as_words(tests), .where = where, .group = {}, .db = db.string()},
                 options_of(criterion, failure_strain, exponent, stress_error_kPa, keep_odd))
      .front();
}

py::dict soils(const std::string& group, const Path& db, const TestNames& tests,
               const std::string& where, const std::string& criterion, double failure_strain,
               std::optional<double> exponent, double stress_error_kPa, bool keep_odd) {
  if (group.empty())
    throw lab::BadInput(
        "missing group, as in 'material'; use triax.soil for one result of all tests");
  py::dict all;
  for (auto& one :
       studied({.tests = as_words(tests), .where = where, .group = group, .db = db.string()},
               options_of(criterion, failure_strain, exponent, stress_error_kPa, keep_odd)))
    all[py::str(one->soil.group)] = one;
  return all;
}

std::shared_ptr<Columns> critical_line(const Soil& s, const Array& p_kPa) {
  if (!s.soil.critical_line)
    throw lab::BadInput("the tests give no critical state line; notes say why");
  const std::vector<double> pressures(p_kPa.data(), p_kPa.data() + p_kPa.size());
  for (const double p : pressures) must_lie("p_kPa", p, 1e-3, 1e6);
  return std::make_shared<Columns>(table_of_line(s.soil, pressures));
}

std::vector<std::string> tests_of_soil(const Soil& s) {
  std::vector<std::string> names;
  names.reserve(s.soil.tests.size());
  for (const auto& test : s.soil.tests) names.push_back(test.name);
  return names;
}

std::string soil_toml(const Soil& s) { return study::toml_document(study::soil_json(s.soil)); }

void bind_class(py::module_& module) {
  py::class_<Soil, std::shared_ptr<Soil>>(module, "Soil", "Properties of one soil from many tests.")
      .def_property_readonly(
          "group", [](const Soil& s) { return s.soil.group; },
          "Material, or the value that the tests have in common.")
      .def_property_readonly(
          "notes", [](const Soil& s) { return s.soil.notes; },
          "Properties that the tests do not determine, with the reason, and tests that are "
          "outliers.")
      .def_property_readonly("names", &tests_of_soil,
                             "Names of the tests, in the order of `tests`.")
      .def_property_readonly(
          "tests", [](const Soil& s) { return s.tests; },
          "One row per test: state at the start of shear, peaks, onset of collapse.\n"
          "q and eta are positive also in extension.")
      .def_property_readonly(
          "critical_states", [](const Soil& s) { return s.critical_states; },
          "One row per test that reached its critical state, or came near it (reached 0), with "
          "standard errors.\n"
          "`test` is the number of the test.")
      .def_property_readonly(
          "circles", [](const Soil& s) { return s.circles; },
          "Largest and smallest effective stress at failure of the tests that determine c' and "
          "phi'.\n"
          "`test` is the number of the test.")
      .def_property_readonly(
          "paths", [](const Soil& s) { return s.paths; },
          "Shear of each test, in the order of `tests`, averaged over steps of axial strain.")
      .def("critical_line", &critical_line, py::arg("p_kPa"),
           "Compute the void ratio of the critical state line at these p', with the 95 % interval "
           "of the line.\n"
           "The form that fits better is used. Raises BadInput if the tests do not determine the "
           "line.")
      .def_property_readonly(
          "toml", &soil_toml,
          "Text of soil.toml (as triax soil --output), from which calibrate can start.")
      .def(
          "write", [](const Soil& s, const Path& path) { write_text(path, soil_toml(s)); },
          py::arg("path"), "Write `toml` to a file. An existing file is overwritten.")
      .def_property_readonly(
          "report",
          [](const Soil& s) { return document(study::json_document(study::soil_json(s.soil))); },
          "Document of triax soil --json. A value that the tests do not determine is None.")
      .def("__repr__", [](const Soil& s) {
        return fmt::format("<triax.Soil '{}': {} tests>", s.soil.group, s.soil.tests.size());
      });
}

}  // namespace

void bind_soil(py::module_& module) {
  bind_class(module);
  module.def("soil", &soil, py::arg("db") = "triax.db", py::kw_only(),
             py::arg("tests") = TestNames(), py::arg("where") = "", py::arg("criterion") = "peak-q",
             py::arg("failure_strain") = 0.15, py::arg("exponent") = py::none(),
             py::arg("stress_error_kPa") = 1.0, py::arg("keep_odd") = false,
             "Estimate the properties of one soil, with intervals, from tests of a database (as "
             "triax soil).\n"
             "`tests` contains numbers and names of tests. If it is empty, all tests are used.\n"
             "`where` is an SQL condition, as in \"material = 'Hostun S28'\".\n"
             "`criterion` defines when a specimen counts as failed for c' and phi':\n"
             "'peak-q', 'peak-ratio', 'strain' at failure_strain, or 'critical-state'.\n"
             "`exponent` fixes the exponent of the power form of the critical state line.\n"
             "Outliers are excluded from the fits unless keep_odd is true.");
  module.def(
      "soils", &soils, py::arg("group"), py::arg("db") = "triax.db", py::kw_only(),
      py::arg("tests") = TestNames(), py::arg("where") = "", py::arg("criterion") = "peak-q",
      py::arg("failure_strain") = 0.15, py::arg("exponent") = py::none(),
      py::arg("stress_error_kPa") = 1.0, py::arg("keep_odd") = false,
      "Estimate soil properties for each value of a column, such as 'material' (as triax soil "
      "--group).\n"
      "Returns a dict from each value to its triax.Soil. The other arguments are as in soil.");
}

}  // namespace triax::python
