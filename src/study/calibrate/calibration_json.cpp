// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/calibration_json.hpp"

#include <algorithm>

#include "src/study/calibrate/implied_domain_json.hpp"
#include "src/study/json_parts.hpp"

namespace triax::study {
namespace {

bool is_stress(Compared quantity) { return quantity == Compared::q || quantity == Compared::p_eff; }

Json parameters_json(const Calibration& c) {
  Json all = Json::array();
  for (const auto& p : c.parameters)
    all.push_back({{"name", p.key},
                   {"value", json_number(p.value)},
                   {"error", p.determined ? json_number(p.error) : Json(nullptr)},
                   {"low", p.determined ? json_number(p.low) : Json(nullptr)},
                   {"high", p.determined ? json_number(p.high) : Json(nullptr)},
                   {"determined", p.determined},
                   {"at_bound", p.at_bound}});
  return all;
}

Json correlation_json(const Eigen::MatrixXd& correlation) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < correlation.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < correlation.cols(); ++j)
      row.push_back(json_number(correlation(i, j)));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json optima_json(const Calibration& c) {
  Json all = Json::array();
  for (const auto& o : c.optima) {
    Json values = Json::object();
    for (std::size_t i = 0; i < o.values.size(); ++i)
      values[c.parameters[i].key] = json_number(o.values[i]);
    all.push_back(
        {{"cost", json_number(o.cost)}, {"found", o.found}, {"values", std::move(values)}});
  }
  return all;
}

Json misfits_json(const Calibration& c) {
  Json all = Json::array();
  for (const auto& m : c.misfits) {
    const double unit = is_stress(m.quantity) ? 1e-3 : 1;
    all.push_back({{"test", m.test},
                   {"quantity", to_string(m.quantity)},
                   {"rms", json_number(unit * m.rms)},
                   {"noise", json_number(unit * m.noise)},
                   {"cost", json_number(m.cost)},
                   {"reached", json_number(m.reached)},
                   {"refusal", json_text(m.refusal)}});
  }
  return all;
}

Json predictions_json(const Calibration& c) {
  Json all = Json::array();
  for (const auto& p : c.predictions)
    all.push_back({{"test", p.test},
                   {"eta", json_number(p.measured)},
                   {"eta_error", json_number(p.measured_error)},
                   {"predicted", json_number(p.predicted)},
                   {"low", p.predicted ? json_number(p.low) : Json(nullptr)},
                   {"high", p.predicted ? json_number(p.high) : Json(nullptr)},
                   {"holds", p.predicted ? Json(p.holds()) : Json(nullptr)}});
  return all;
}

Json set_json(const Calibration& c) {
  Json set = Json::object();
  for (const auto& [key, value] : c.material.parameters.numbers) set[key] = json_number(value);
  for (const auto& [key, values] : c.material.parameters.lists) set[key] = values;
  return set;
}

}  // namespace

std::string calibration_json(const Calibration& c) {
  Json tests = Json::array();
  for (const auto& path : c.measured)
    tests.push_back({{"id", path.test},
                     {"name", path.name},
                     {"imposed", to_string(path.imposed)},
                     {"void_ratio", json_number(path.void_ratio)},
                     {"p_eff_kPa", json_kPa(path.start.p_eff)},
                     {"knots", path.knots.size()}});
  return json_document({{"law", c.material.law->name},
                        {"start", c.start.name},
                        {"interrupted", c.interrupted},
                        {"cost", json_number(c.cost)},
                        {"start_cost", json_number(c.start_cost)},
                        {"confidence", c.confidence},
                        {"degrees_of_freedom", json_number(c.degrees_of_freedom)},
                        {"parameters", parameters_json(c)},
                        {"correlation", correlation_json(c.correlation)},
                        {"set", set_json(c)},
                        {"searches", {{"run", c.searches}, {"at_the_best", c.ended_at_best}}},
                        {"optima", optima_json(c)},
                        {"tests", std::move(tests)},
                        {"misfits", misfits_json(c)},
                        {"predictions", predictions_json(c)},
                        {"domain", c.domain ? implied_domain_json(*c.domain) : Json(nullptr)},
                        {"driver_runs", c.runs},
                        {"notes", c.notes}});
}

}  // namespace triax::study
