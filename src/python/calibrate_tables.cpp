// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/python/calibrate_tables.hpp"

#include "lab/results/reading.hpp"

namespace triax::python {

namespace {

using study::ParameterEstimate;
using study::PathKnot;
using study::Prediction;

void add_knots(Columns& table, const std::string& prefix, const std::vector<PathKnot>& knots,
               std::size_t rows) {
  const auto number = [&](const char* name, auto of) {
    table.add_of(prefix + name, knots, of);
    std::get<std::vector<double>>(table.columns.back().second).resize(rows, lab::kMissing);
  };
  number("axial_strain", [](const PathKnot& k) { return k.axial_strain; });
  number("volumetric_strain", [](const PathKnot& k) { return k.volumetric_strain; });
  number("q_kPa", [](const PathKnot& k) { return k.q / 1e3; });
  number("p_eff_kPa", [](const PathKnot& k) { return k.p_eff / 1e3; });
}

}  // namespace

Columns table_of_parameters(const study::Calibration& calibration) {
  Columns table;
  const auto number = [&](const char* name, double ParameterEstimate::*of, bool always) {
    table.add_of(name, calibration.parameters, [&](const ParameterEstimate& p) {
      return always || p.determined ? p.*of : lab::kMissing;
    });
  };
  number("value", &ParameterEstimate::value, true);
  number("error", &ParameterEstimate::error, false);
  number("low", &ParameterEstimate::low, false);
  number("high", &ParameterEstimate::high, false);
  table.add_of<std::int64_t>("determined", calibration.parameters,
                             [](const ParameterEstimate& p) { return p.determined; });
  table.add_of<std::int64_t>("at_bound", calibration.parameters,
                             [](const ParameterEstimate& p) { return p.at_bound; });
  return table;
}

Columns table_of_optima(const study::Calibration& calibration) {
  Columns table;
  table.add_of("cost", calibration.optima, [](const study::Optimum& o) { return o.cost; });
  table.add_of<std::int64_t>("found", calibration.optima,
                             [](const study::Optimum& o) { return o.found; });
  for (std::size_t i = 0; i < calibration.parameters.size(); ++i)
    table.add_of(calibration.parameters[i].key, calibration.optima,
                 [&](const study::Optimum& o) { return o.values[i]; });
  return table;
}

Columns table_of_predictions(const study::Calibration& calibration) {
  Columns table;
  const auto number = [&](const char* name, auto of) {
    table.add_of(name, calibration.predictions, of);
  };
  const auto where_predicted = [](const Prediction& p, double value) {
    return p.predicted ? value : lab::kMissing;
  };
  table.add_of<std::int64_t>("test", calibration.predictions,
                             [](const Prediction& p) { return p.id; });
  number("eta", [](const Prediction& p) { return p.measured; });
  number("eta_error", [](const Prediction& p) { return p.measured_error; });
  number("predicted", [](const Prediction& p) { return p.predicted.value_or(lab::kMissing); });
  number("low", [&](const Prediction& p) { return where_predicted(p, p.low); });
  number("high", [&](const Prediction& p) { return where_predicted(p, p.high); });
  return table;
}

Columns table_of_curve(const study::MeasuredPath& measured, const study::ComputedPath& computed) {
  Columns table;
  add_knots(table, "", measured.knots, measured.knots.size());
  add_knots(table, "computed_", computed.knots, measured.knots.size());
  return table;
}

}  // namespace triax::python
