// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/soil_json.hpp"

#include <cmath>

#include "src/study/soil/test_json.hpp"
#include "src/study/version.hpp"

namespace triax::study {
namespace {

/// Ends of a range of ln p′ in kPa.
Json pressures(const LineFit& line) {
  return Json::array({json_number(std::exp(line.x_low)), json_number(std::exp(line.x_high))});
}

Json negative(const Estimate& e) {
  return json_estimate(Estimate{-e.value, e.error, -e.high, -e.low, e.tests});
}

Json critical_line(const Soil& soil) {
  Json lines;
  if (!soil.critical_line) return lines;
  const LineFit& line = soil.critical_line->line;
  lines["better"] = soil.power_is_better ? "power" : "log_linear";
  lines["log_linear"] = {{"gamma", json_estimate(line.intercept())},
                         {"lambda", negative(line.slope())},
                         {"correlation", json_number(-line.correlation())},
                         {"scatter", json_number(line.scatter)},
                         {"p_eff_range_kPa", pressures(line)}};
  const PowerLine& power = *soil.critical_power;
  lines["power"] = {{"critical_void_ratio", json_estimate(power.void_ratio)},
                    {"critical_slope", json_estimate(power.slope)},
                    {"critical_exponent", json_estimate(power.exponent)},
                    {"exponent_held", power.exponent_held},
                    {"critical_pressure_kPa", kPowerPressure_kPa},
                    {"scatter", json_number(power.line.scatter)},
                    {"p_eff_range_kPa", pressures(line)}};
  return lines;
}

Json friction(const Soil& soil) {
  Json f;
  if (soil.critical_ratio) {
    f["critical_stress_ratio"] = json_estimate(soil.critical_ratio->fit.mean);
    f["critical_friction_angle_deg"] =
        json_estimate(friction_angle(soil.critical_ratio->fit.mean, false));
    f["critical_stress_ratio_scatter"] = json_number(soil.critical_ratio->fit.scatter);
  }
  if (soil.extension_ratio) {
    f["extension_stress_ratio"] = json_estimate(soil.extension_ratio->fit.mean);
    f["extension_friction_angle_deg"] =
        json_estimate(friction_angle(soil.extension_ratio->fit.mean, true));
  }
  if (soil.extension_share) f["extension_ratio"] = json_estimate(*soil.extension_share);
  if (soil.peak_angle_deg) {
    f["peak_friction_angle_deg"] = json_estimate(soil.peak_angle_deg->fit.mean);
    f["peak_friction_angle_scatter_deg"] = json_number(soil.peak_angle_deg->fit.scatter);
  }
  if (soil.stress_dilatancy) {
    const LineFit& line = soil.stress_dilatancy->line;
    const Estimate slope = line.slope();
    f["stress_ratio_without_dilatancy"] = json_estimate(line.intercept());
    f["peak_dilatancy_slope"] = json_estimate(slope);
    f["volumetric_coupling"] = json_estimate(
        Estimate{1 - slope.value, slope.error, 1 - slope.high, 1 - slope.low, slope.tests});
  }
  if (soil.dilatancy_over_state) {
    f["state_dilatancy"] = json_estimate(soil.dilatancy_over_state->line.slope());
    f["dilatancy_at_zero_state"] = json_estimate(soil.dilatancy_over_state->line.intercept());
  }
  return f;
}

Json strength(const Soil& soil) {
  Json s;
  if (!soil.strength) return s;
  const StrengthSet& set = *soil.strength;
  s["criterion"] = std::string(to_string(set.criterion));
  s["cohesion_kPa"] = json_estimate(set.cohesion_kPa);
  s["friction_angle_deg"] = json_estimate(set.friction_angle_deg);
  if (set.friction_angle_without_cohesion_deg)
    s["friction_angle_without_cohesion_deg"] =
        json_estimate(*set.friction_angle_without_cohesion_deg);
  Json circles = Json::array();
  for (const auto& c : set.circles)
    circles.push_back({{"name", c.name},
                       {"major_kPa", json_number(c.major_kPa)},
                       {"minor_kPa", json_number(c.minor_kPa)}});
  s["circles"] = circles;
  return s;
}

Json trend_json(const std::optional<Trend>& trend, const char* at_zero) {
  if (!trend) return nullptr;
  return {
      {at_zero, json_estimate(trend->line.intercept())},
      {"slope", json_estimate(trend->line.slope())},
      {"scatter", json_number(trend->line.scatter)},
      {"range", Json::array({json_number(trend->line.x_low), json_number(trend->line.x_high)})}};
}

Json onsets(const Soil& soil) {
  Json all;
  for (const auto& of : soil.onsets) {
    Json one = trend_json(of.over_state, "at_zero_state");
    if (one.is_null()) one = Json::object();
    one["over_void_ratio"] = trend_json(of.over_void_ratio, "at_zero");
    one["over_log_pressure"] = trend_json(of.over_pressure, "at_1_kPa");
    const std::string name =
        std::string(lab::to_string(of.kind)) + (of.extension ? "_extension" : "");
    all[name] = one;
  }
  return all;
}

Json cyclic(const Soil& soil) {
  Json all = Json::array();
  for (const auto& of : soil.cyclic) {
    const LineFit& line = of.trend.line;
    const Estimate a = line.intercept();
    all.push_back({{"criterion", of.criterion},
                   {"a", json_estimate(Estimate{std::exp(a.value), std::exp(a.value) * a.error,
                                                std::exp(a.low), std::exp(a.high), a.tests})},
                   {"b", negative(line.slope())},
                   {"stress_ratio_at_15_cycles", json_number(of.at_cycles(15))}});
  }
  return all;
}

}  // namespace

Json soil_json(const Soil& soil) {
  Json document = {{"kind", "soil"}, {"version", version()}, {"group", soil.group}};
  document["notes"] = soil.notes;
  document["critical_state_line"] = critical_line(soil);
  document["friction"] = friction(soil);
  document["strength"] = strength(soil);
  document["void_ratio"] = {{"densest", json_number(soil.densest)},
                            {"loosest", json_number(soil.loosest)}};
  document["onset"] = onsets(soil);
  document["undrained_strength"] = trend_json(soil.strength_over_state, "at_zero_state");
  document["cyclic"] = cyclic(soil);
  Json tests = Json::array();
  for (const auto& test : soil.tests) tests.push_back(test_json(test));
  document["tests"] = tests;
  return document;
}

std::string json_of_soils(const std::vector<Soil>& soils) {
  if (soils.size() == 1) return json_document(soil_json(soils.front()));
  Json all = Json::array();
  for (const auto& soil : soils) all.push_back(soil_json(soil));
  return json_document(all);
}

}  // namespace triax::study
