// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "lab/results/record_header.hpp"
#include "src/python/bindings.hpp"
#include "src/python/calibrate_tables.hpp"
#include "src/python/documents.hpp"
#include "src/python/heeding.hpp"
#include "src/python/material.hpp"
#include "src/python/ranges.hpp"
#include "src/study/calibrate/calibrated_set.hpp"
#include "src/study/calibrate/calibration_json.hpp"
#include "src/study/calibrate/requested_calibration.hpp"

namespace triax::python {

namespace py = pybind11;

namespace {

using Path = std::filesystem::path;
using Names = std::vector<std::string>;
using Fixed = std::map<std::string, std::optional<double>>;

struct Calibration {
  explicit Calibration(study::Calibration of)
      : found(std::move(of)),
        parameters(std::make_shared<Columns>(table_of_parameters(found))),
        optima(std::make_shared<Columns>(table_of_optima(found))),
        predictions(std::make_shared<Columns>(table_of_predictions(found))),
        correlation(static_cast<std::size_t>(found.correlation.size())) {
    const auto count = found.correlation.rows();
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        correlation.data(), count, count) = found.correlation;
    for (std::size_t i = 0; i < found.measured.size(); ++i)
      curves.push_back(
          std::make_shared<Columns>(table_of_curve(found.measured[i], found.computed[i])));
  }
  study::Calibration found;
  std::shared_ptr<Columns> parameters, optima, predictions;
  std::vector<double> correlation;  ///< row by row
  std::vector<std::shared_ptr<Columns>> curves;
};

study::CalibrationRequest requested(const study::StartWish& wish, const std::string& db,
                                    const TestNames& tests, int searches, std::uint64_t seed,
                                    double void_ratio_error, int threads) {
  must_lie("searches", searches, 1, 10000);
  must_lie("seed", static_cast<double>(seed), 0, static_cast<double>(lab::kMaxSeed));
  must_lie("void_ratio_error", void_ratio_error, 0, 0.5);
  must_lie("threads", threads, 0, 4096);
  const py::gil_scoped_release free;
  auto request = study::requested_calibration(wish, db, as_words(tests));
  request.searches = searches;
  request.seed = seed;
  request.threads = threads;
  request.void_ratio_error = void_ratio_error;
  return request;
}

std::shared_ptr<Calibration> calibrate(const Path& db, const std::string& law,
                                       const TestNames& tests, const std::optional<Path>& start,
                                       const Names& free, const Fixed& fix, int searches,
                                       std::uint64_t seed, double void_ratio_error, int threads,
                                       const py::object& progress) {
  const study::StartWish wish{.law = law,
                              .start = start ? start->string() : "",
                              .free = free,
                              .fixed = {fix.begin(), fix.end()}};
  const auto request =
      requested(wish, db.string(), tests, searches, seed, void_ratio_error, threads);
  Heeding heeding(progress);
  std::shared_ptr<Calibration> best;
  try {
    const py::gil_scoped_release released;
    best = std::make_shared<Calibration>(study::calibrate(
        request, [&](const std::string& what, double share) { heeding.tell(what, share); },
        [&] { return heeding.go_on(); }));
  } catch (const lab::WorkFailed&) {
    heeding.raise(py::none());
    throw;
  }
  heeding.raise(py::cast(best));
  return best;
}

Names keys_of(const Calibration& c, bool all) {
  Names names;
  for (const auto& p : c.found.parameters)
    if (all || !p.determined) names.push_back(p.key);
  return names;
}

Names tests_of_calibration(const Calibration& c) {
  Names names;
  names.reserve(c.found.measured.size());
  for (const auto& path : c.found.measured) names.push_back(path.name);
  return names;
}

std::string set_toml(const Calibration& c) { return study::calibrated_toml(c.found, "calibrated"); }

void bind_values(py::class_<Calibration, std::shared_ptr<Calibration>>& calibration) {
  calibration
      .def_property_readonly(
          "law", [](const Calibration& c) { return c.found.material.law->name; },
          "Name of the law.")
      .def_property_readonly(
          "material",
          [](const Calibration& c) { return std::make_shared<Material>(c.found.material); },
          "Law with the best parameters, for probe, domain and Points (undrained, if the law "
          "distinguishes drainage).")
      .def_property_readonly(
          "interrupted", [](const Calibration& c) { return c.found.interrupted; },
          "True if the calibration was stopped early. The result is then the best so far.")
      .def_property_readonly(
          "cost", [](const Calibration& c) { return c.found.cost; },
          "Misfit of the best parameters. 1 is a difference of 2 % of the span in every quantity "
          "of every test.")
      .def_property_readonly(
          "start_cost", [](const Calibration& c) { return c.found.start_cost; },
          "Cost of the set from which the searches started; None if that set is out of the ranges.")
      .def_property_readonly(
          "names", [](const Calibration& c) { return keys_of(c, true); },
          "Keys of the parameters that were searched, in the order of `parameters` and "
          "`correlation`.")
      .def_property_readonly(
          "undetermined", [](const Calibration& c) { return keys_of(c, false); },
          "Keys of the searched parameters that the tests do not determine.")
      .def_property_readonly(
          "parameters", [](const Calibration& c) { return c.parameters; },
          "One row per parameter: value, standard error, 95 % interval, determined, at_bound.\n"
          "The error and the interval are NaN if the tests do not determine the parameter.")
      .def_property_readonly(
          "correlation",
          [](const py::object& self) {
            const auto& c = self.cast<const Calibration&>();
            const auto count = static_cast<py::ssize_t>(c.found.correlation.rows());
            return read_only_view(c.correlation, self, {count, count});
          },
          "Correlation of the parameters, [names, names].");
}

}  // namespace

void bind_calibrate(py::module_& module) {
  py::class_<Calibration, std::shared_ptr<Calibration>> calibration(
      module, "Calibration", "Parameters of a law from tests, with their uncertainty.");
  bind_values(calibration);
  calibration
      .def_property_readonly(
          "optima", [](const Calibration& c) { return c.optima; },
          "The best optimum and others that fit about as well: cost, number of searches that found "
          "it, values by key.")
      .def_property_readonly("tests", &tests_of_calibration,
                             "Names of the tests, in the order of `curves`.")
      .def_property_readonly(
          "curves", [](const Calibration& c) { return c.curves; },
          "Each test as measured, and as computed with the law (computed_...; NaN if the law did "
          "not reach that state).")
      .def_property_readonly(
          "predictions", [](const Calibration& c) { return c.predictions; },
          "One row per test that collapsed. `test` is the number of the test.\n"
          "eta at collapse is given as measured, and as predicted from the other tests with a 90 % "
          "interval.\n"
          "The prediction and the interval are NaN if the law does not collapse.")
      .def_property_readonly(
          "toml", &set_toml,
          "Text of a parameter file with one set, 'calibrated' (two sets for NorSand).")
      .def(
          "write",
          [](const Calibration& c, const Path& path) {
            write_text(path, study::calibrated_toml(c.found, study::set_name_from(path.string())));
          },
          py::arg("path"),
          "Write the parameter file (as triax calibrate --output). An existing file is "
          "overwritten.\n"
          "The set is named after the file: my_sand.toml contains LAW/my_sand.\n"
          "Use the set with triax.Material(name, file=), in paths and in programmes.")
      .def_property_readonly(
          "report", [](const Calibration& c) { return document(calibration_json(c.found)); },
          "Document of triax calibrate --json.")
      .def("__repr__", [](const Calibration& c) {
        return fmt::format("<triax.Calibration of {} from {} tests, cost {:.4g}{}>",
                           c.found.material.law->name, c.found.measured.size(), c.found.cost,
                           c.found.interrupted ? ", interrupted" : "");
      });
  module.def(
      "calibrate", &calibrate, py::arg("db"), py::arg("law"), py::kw_only(),
      py::arg("tests") = TestNames(), py::arg("start") = py::none(), py::arg("free") = Names(),
      py::arg("fix") = Fixed(), py::arg("searches") = 3, py::arg("seed") = 1,
      py::arg("void_ratio_error") = 0.0, py::arg("threads") = 0, py::arg("progress") = py::none(),
      "Find the parameters of a law from tests of a database (as triax calibrate).\n"
      "`tests` contains numbers and names of tests. If it is empty, all tests are used.\n"
      "`start` is a set 'LAW/SET', a parameter file or a file written by Soil.write.\n"
      "`free` names the parameters to search.\n"
      "`fix` names those to keep: {'poisson_ratio': 0.05}, or None for the value of the start.\n"
      "progress(what, fraction) is called now and then.\n"
      "If it returns False, the best result so far is returned.\n"
      "Ctrl-C or an exception in `progress` also ends the calibration.\n"
      "The exception then has the best result so far as `best`.");
}

}  // namespace triax::python
