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
  must_lie("seed", static_cast<double>(seed), 0, static_cast<double>(lab::kLargestSeed));
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
          "law", [](const Calibration& c) { return c.found.material.law->name; }, "Its name.")
      .def_property_readonly(
          "material",
          [](const Calibration& c) { return std::make_shared<Material>(c.found.material); },
          "The law with the best parameters, as probe, domain and Points take it (undrained, "
          "where the law distinguishes).")
      .def_property_readonly(
          "interrupted", [](const Calibration& c) { return c.found.interrupted; },
          "Whether it was stopped: then it is the best so far.")
      .def_property_readonly(
          "cost", [](const Calibration& c) { return c.found.cost; },
          "1 is off by 2 % of its span in every quantity of every test.")
      .def_property_readonly(
          "start_cost", [](const Calibration& c) { return c.found.start_cost; },
          "Of the set that it started from; None where that is out of the ranges.")
      .def_property_readonly(
          "names", [](const Calibration& c) { return keys_of(c, true); },
          "Keys of the parameters that were searched, in the order of `parameters` and "
          "`correlation`.")
      .def_property_readonly(
          "undetermined", [](const Calibration& c) { return keys_of(c, false); },
          "Keys of those that the tests do not determine.")
      .def_property_readonly(
          "parameters", [](const Calibration& c) { return c.parameters; },
          "A row a parameter: value, standard error, 95 % interval (NaN where the tests do not "
          "determine it), determined, at_bound.")
      .def_property_readonly(
          "correlation",
          [](const py::object& self) {
            const auto& c = self.cast<const Calibration&>();
            const auto count = static_cast<py::ssize_t>(c.found.correlation.rows());
            return read_only_view(c.correlation, self, {count, count});
          },
          "Of the parameters, [names, names].");
}

}  // namespace

void bind_calibrate(py::module_& module) {
  py::class_<Calibration, std::shared_ptr<Calibration>> calibration(
      module, "Calibration", "Parameters of a law from tests, and how sure they are.");
  bind_values(calibration);
  calibration
      .def_property_readonly(
          "optima", [](const Calibration& c) { return c.optima; },
          "The best and others that fit about as well: cost, how many searches found it, its "
          "values by their keys.")
      .def_property_readonly("tests", &tests_of_calibration,
                             "Names of the tests, in the order of `curves`.")
      .def_property_readonly(
          "curves", [](const Calibration& c) { return c.curves; },
          "Each test as it was measured, and as the law has it (computed_...; NaN where it did "
          "not come to).")
      .def_property_readonly(
          "predictions", [](const Calibration& c) { return c.predictions; },
          "A row a test that collapsed (`test` is its number): eta at collapse as measured and "
          "predicted from the other tests, with a\n"
          "90 % interval; NaN where the law does not collapse.")
      .def_property_readonly("toml", &set_toml,
                             "A parameter file with one set, 'calibrated' (of NorSand two).")
      .def(
          "write",
          [](const Calibration& c, const Path& path) {
            write_text(path, study::calibrated_toml(c.found, study::set_name_from(path.string())));
          },
          py::arg("path"),
          "Writes the parameter file of triax calibrate --output, over what is there; its set is "
          "named after the file: my_sand.toml\n"
          "holds LAW/my_sand, for triax.Material(name, file=), paths and programmes.")
      .def_property_readonly(
          "report", [](const Calibration& c) { return document(calibration_json(c.found)); },
          "The document of triax calibrate --json.")
      .def("__repr__", [](const Calibration& c) {
        return fmt::format("<triax.Calibration of {} from {} tests, cost {:.4g}{}>",
                           c.found.material.law->name, c.found.measured.size(), c.found.cost,
                           c.found.interrupted ? ", interrupted" : "");
      });
  module.def("calibrate", &calibrate, py::arg("db"), py::arg("law"), py::kw_only(),
             py::arg("tests") = TestNames(), py::arg("start") = py::none(),
             py::arg("free") = Names(), py::arg("fix") = Fixed(), py::arg("searches") = 3,
             py::arg("seed") = 1, py::arg("void_ratio_error") = 0.0, py::arg("threads") = 0,
             py::arg("progress") = py::none(),
             "Finds the parameters of a law from tests of a database (all, or these numbers and "
             "names): triax calibrate.\n"
             "`start` is a set 'LAW/SET', a parameter file or what Soil.write wrote; `free` names "
             "the parameters to search, `fix` those to\n"
             "keep: {'poisson_ratio': 0.05}, or None for the value of the start. "
             "progress(what, share) is called now and then; where it gives\n"
             "False, the best so far is returned. Ctrl-C and what `progress` raises end it too, "
             "and the exception has the best so far as `best`.");
}

}  // namespace triax::python
