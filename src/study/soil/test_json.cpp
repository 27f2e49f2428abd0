// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/test_json.hpp"

#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"

namespace triax::study {
namespace {

Json maybe(const std::optional<Estimate>& e) { return e ? json_estimate(*e) : Json(nullptr); }

void add_critical(Json& row, const CriticalState& c) {
  row["critical"] = std::string(to_string(c.kind));
  row["critical_reason"] = json_text(c.reason);
  if (c.kind == CriticalKind::none) return;
  const double p = std::exp(c.log_p.value);
  row["critical_stress_ratio"] = json_estimate(c.eta);
  row["critical_p_eff_kPa"] =
      json_estimate({p, p * c.log_p.error, std::exp(c.log_p.low), std::exp(c.log_p.high), 1});
  row["critical_q_kPa"] = json_number(p * c.eta.value);
  row["critical_void_ratio"] = maybe(c.void_ratio);
}

void add_peaks(Json& row, const TestPoints& t) {
  if (t.peak_eta) {
    row["peak_stress_ratio"] = json_estimate(measured(t.peak_eta->eta(), t.peak_eta_error));
    row["peak_friction_angle_deg"] =
        json_number(friction_angle(measured(t.peak_eta->eta(), 0), t.extension).value);
  }
  if (t.peak_q) {
    row["peak_q_kPa"] = json_number(t.peak_q->q_kPa);
    row["peak_axial_strain"] = json_number(t.peak_q->axial_strain);
  }
  row["dilatancy_at_peak"] = maybe(t.dilatancy_at_peak);
  if (t.phase_transformation) {
    row["phase_transformation_stress_ratio"] = json_number(t.phase_transformation->eta());
    row["phase_transformation_p_eff_kPa"] = json_number(t.phase_transformation->p_eff_kPa);
  }
  row["brittleness"] = json_number(t.brittleness);
  row["strength_ratio"] = json_number(t.strength_ratio);
}

void add_cyclic(Json& row, const lab::CyclicLoading& c) {
  row["cyclic_stress_ratio"] = json_number(c.stress_ratio);
  if (c.liquefied) row["cycles_to_pore_pressure_ratio"] = c.liquefied->cycle;
  if (c.double_amplitude) row["cycles_to_double_amplitude"] = c.double_amplitude->cycle;
}

}  // namespace

Json json_estimate(const Estimate& e) {
  return {{"value", json_number(e.value)},
          {"error", json_number(e.error)},
          {"low", json_number(e.low)},
          {"high", json_number(e.high)},
          {"tests", e.tests}};
}

Json test_json(const TestPoints& t) {
  Json row = {{"id", t.id}, {"name", t.name}, {"used", t.used}, {"reason", t.reason}};
  row["origin"] = t.simulated ? "simulated" : "recorded";
  row["drainage"] = t.drained ? "open" : "closed";
  row["sense"] = t.extension ? "extension" : "compression";
  row["void_ratio"] = json_number(t.void_ratio);
  row["p_eff_kPa"] = json_number(t.p_eff_kPa);
  row["state_parameter"] = maybe(t.state_parameter);
  if (t.end) {
    row["end_axial_strain"] = json_number(t.end->axial_strain);
    row["end_q_kPa"] = json_number(t.end->q_kPa);
    row["end_p_eff_kPa"] = json_number(t.end->p_eff_kPa);
    row["end_void_ratio"] = json_number(t.end->void_ratio);
  }
  if (!t.cyclic) add_critical(row, t.critical);
  add_peaks(row, t);
  if (t.collapse) row["collapse"] = std::string(lab::to_string(*t.collapse));
  row["onset_stress_ratio"] = maybe(t.onset_eta);
  if (t.cyclic) add_cyclic(row, *t.cyclic);
  return row;
}

}  // namespace triax::study
