// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/python/soil_tables.hpp"

#include <cmath>

#include "lab/results/reading.hpp"

namespace triax::python {

namespace {

using study::Estimate;
using study::TestPoint;
using study::TestPoints;

double known(const std::optional<double>& value) { return value.value_or(lab::kMissing); }
double value_of(const std::optional<Estimate>& e) { return e ? e->value : lab::kMissing; }
double error_of(const std::optional<Estimate>& e) { return e ? e->error : lab::kMissing; }

}  // namespace

Columns table_of_tests(const study::Soil& soil) {
  Columns table;
  const auto whole = [&](const char* name, auto of) {
    table.add_of<std::int64_t>(name, soil.tests, of);
  };
  const auto number = [&](const char* name, auto of) { table.add_of(name, soil.tests, of); };
  const auto peak_q = [&](const char* name, auto of) {
    number(name, [&](const TestPoints& t) { return t.peak_q ? of(*t.peak_q) : lab::kMissing; });
  };
  whole("id", [](const TestPoints& t) { return t.id; });
  whole("used", [](const TestPoints& t) { return t.used; });
  whole("simulated", [](const TestPoints& t) { return t.simulated; });
  whole("drained", [](const TestPoints& t) { return t.drained; });
  whole("extension", [](const TestPoints& t) { return t.extension; });
  number("void_ratio", [](const TestPoints& t) { return known(t.void_ratio); });
  number("p_eff_kPa", [](const TestPoints& t) { return known(t.p_eff_kPa); });
  number("state_parameter", [](const TestPoints& t) { return value_of(t.state_parameter); });
  number("state_parameter_error", [](const TestPoints& t) { return error_of(t.state_parameter); });
  peak_q("peak_q_kPa", [](const TestPoint& p) { return p.q_kPa; });
  peak_q("peak_axial_strain", [](const TestPoint& p) { return p.axial_strain; });
  number("peak_stress_ratio",
         [](const TestPoints& t) { return t.peak_eta ? t.peak_eta->eta() : lab::kMissing; });
  number("peak_stress_ratio_error",
         [](const TestPoints& t) { return t.peak_eta ? t.peak_eta_error : lab::kMissing; });
  number("dilatancy_at_peak", [](const TestPoints& t) { return value_of(t.dilatancy_at_peak); });
  number("brittleness", [](const TestPoints& t) { return known(t.brittleness); });
  number("strength_ratio", [](const TestPoints& t) { return known(t.strength_ratio); });
  number("onset_stress_ratio", [](const TestPoints& t) { return value_of(t.onset_eta); });
  number("onset_p_eff_kPa", [](const TestPoints& t) { return known(t.onset_p_eff_kPa); });
  number("onset_q_kPa", [](const TestPoints& t) { return known(t.onset_q_kPa); });
  return table;
}

Columns table_of_critical_states(const study::Soil& soil) {
  std::vector<TestPoints> rested;
  for (const TestPoints& t : soil.tests)
    if (t.used && !t.cyclic && t.critical.kind != study::CriticalKind::none) rested.push_back(t);
  Columns table;
  const auto whole = [&](const char* name, auto of) {
    table.add_of<std::int64_t>(name, rested, of);
  };
  const auto number = [&](const char* name, auto of) { table.add_of(name, rested, of); };
  const auto p = [](const TestPoints& t) { return std::exp(t.critical.log_p.value); };
  whole("test", [](const TestPoints& t) { return t.id; });
  whole("reached",
        [](const TestPoints& t) { return t.critical.kind == study::CriticalKind::reached; });
  whole("drained", [](const TestPoints& t) { return t.drained; });
  whole("extension", [](const TestPoints& t) { return t.extension; });
  number("stress_ratio", [](const TestPoints& t) { return t.critical.eta.value; });
  number("stress_ratio_error", [](const TestPoints& t) { return t.critical.eta.error; });
  number("p_eff_kPa", p);
  number("p_eff_error_kPa", [&](const TestPoints& t) { return p(t) * t.critical.log_p.error; });
  number("q_kPa", [&](const TestPoints& t) { return p(t) * t.critical.eta.value; });
  number("void_ratio", [](const TestPoints& t) { return value_of(t.critical.void_ratio); });
  number("void_ratio_error", [](const TestPoints& t) { return error_of(t.critical.void_ratio); });
  return table;
}

Columns table_of_circles(const study::Soil& soil) {
  const auto circles = soil.strength ? soil.strength->circles : std::vector<study::MohrCircle>();
  Columns table;
  table.add_of<std::int64_t>("test", circles,
                             [&](const study::MohrCircle& c) { return soil.tests[c.test].id; });
  table.add_of("major_kPa", circles, [](const study::MohrCircle& c) { return c.major_kPa; });
  table.add_of("minor_kPa", circles, [](const study::MohrCircle& c) { return c.minor_kPa; });
  return table;
}

Columns table_of_path(const TestPoints& test) {
  Columns table;
  table.add_of("axial_strain", test.path, [](const TestPoint& p) { return p.axial_strain; });
  table.add_of("q_kPa", test.path, [](const TestPoint& p) { return p.q_kPa; });
  table.add_of("p_eff_kPa", test.path, [](const TestPoint& p) { return p.p_eff_kPa; });
  table.add_of("void_ratio", test.path, [](const TestPoint& p) { return known(p.void_ratio); });
  return table;
}

Columns table_of_line(const study::Soil& soil, const std::vector<double>& p_eff_kPa) {
  Columns table;
  const auto number = [&](const char* name, auto of) {
    table.add_of(name, p_eff_kPa, [&](double p) { return of(soil.critical_void_ratio(p)); });
  };
  table.add("p_eff_kPa") = p_eff_kPa;
  number("void_ratio", [](const Estimate& e) { return e.value; });
  number("low", [](const Estimate& e) { return e.low; });
  number("high", [](const Estimate& e) { return e.high; });
  return table;
}

}  // namespace triax::python
