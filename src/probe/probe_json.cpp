// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_json.hpp"

#include "src/probe/control_text.hpp"
#include "src/probe/state_json.hpp"
#include "src/study/json_parts.hpp"

namespace triax::src {
namespace {

study::Json normalised(const sim::Probe& probe) {
  return probe.answered ? study::json_number(probe.normalised) : study::Json(nullptr);
}

study::Json probing_json(const study::Probing& probing) {
  const bool stress = probing.kind == sim::ProbeKind::stress;
  return {{"kind", stress ? "stress" : "strain"},
          {"plane", probing.axisymmetric() ? "axisymmetric" : "plane-strain"},
          {"norm_kPa", stress ? study::json_kPa(probing.norm) : study::Json(nullptr)},
          {"norm_strain", stress ? study::Json(nullptr) : study::Json(probing.norm)},
          {"step_deg", probing.step_deg()},
          {"finite", probing.finite},
          {"norms", probing.axisymmetric() ? "full" : "plane"}};
}

study::Json increment_json(const sim::PlaneVector& v, const study::Probing& probing, double unit,
                           const std::string& suffix) {
  const double lateral = probing.axisymmetric() ? v.x() / std::numbers::sqrt2 : v.x();
  return {{"axial" + suffix, study::json_number(v.y() / unit)},
          {(probing.axisymmetric() ? "radial" : "lateral") + suffix,
           study::json_number(lateral / unit)}};
}

study::Json probe_json(const sim::Probe& probe, const study::Probing& probing) {
  study::Json one = {{"alpha_deg", study::json_deg(probe.angle)},
                     {"w2_normalised", normalised(probe)}};
  one["w2_Pa"] =
      probe.answered ? study::json_number(probe.second_order_work) : study::Json(nullptr);
  one["stress"] =
      probe.answered ? increment_json(probe.stress, probing, 1e3, "_kPa") : study::Json(nullptr);
  one["strain"] =
      probe.answered ? increment_json(probe.strain, probing, 1, "") : study::Json(nullptr);
  one["answered"] = probe.answered;
  return one;
}

study::Json cone_json(const sim::Cone& cone) {
  return {{"from_deg", study::json_deg(cone.from)},
          {"to_deg", study::json_deg(cone.to)},
          {"opening_deg", study::json_deg(cone.opening())},
          {"strongest_deg", study::json_deg(cone.strongest.angle)},
          {"w2_normalised_least", normalised(cone.strongest)}};
}

/// Null for a state that no test was in, or whose increment is not known.
study::Json own_json(const study::ProbedState& state, const study::Probing& probing) {
  if (!state.test || !state.test->increment) return nullptr;
  const lab::MeasuredIncrement& own = *state.test->increment;
  const bool comparable = state.own && probing.kind == sim::ProbeKind::stress;
  study::Json own_json = {
      {"alpha_deg", study::json_deg(own.angle)},
      {"alpha_error_deg", study::json_deg(own.angle_error)},
      {"w2_normalised_measured", study::json_number(own.normalised)},
      {"w2_normalised_error", study::json_number(own.normalised_error)},
      {"window_readings", own.window_readings},
      {"w2_normalised_law", state.own ? normalised(*state.own) : study::Json(nullptr)},
      {"in_cone", comparable ? study::Json(false) : study::Json(nullptr)},
      {"certain", nullptr},
      {"cone", nullptr},
      {"nearest_edge_deg", nullptr}};
  if (!comparable) return own_json;
  if (const auto& place = state.own_place) {
    own_json["in_cone"] = place->inside;
    own_json["certain"] = place->certain(own.angle_error);
    own_json["cone"] = place->cone;
    own_json["nearest_edge_deg"] = study::json_deg(place->to_edge);
  }
  return own_json;
}

study::Json answer_json(const sim::ControlAnswer& answer) {
  return {{"control", state_name(answer.state)}, {"index", study::json_number(answer.index)}};
}

/// Eq. (32) or (33), from (dε₁, dσ₃/R) to (dσ₁ − dσ₃/R, dε₁ + 2R dε₃ or dε₁ + R dε₃), in kPa.
study::Json matrix_json(const std::optional<sim::ControlMatrix>& matrix) {
  if (!matrix) return nullptr;
  const Eigen::Matrix2d& m = matrix->entries;
  return {{"stress_by_axial_strain_kPa", study::json_number(m(0, 0) / 1e3)},
          {"stress_by_radial_stress_over_R", study::json_number(m(0, 1))},
          {"strain_by_axial_strain", study::json_number(m(1, 0))},
          {"strain_by_radial_stress_over_R_per_kPa", study::json_number(1e3 * m(1, 1))},
          {"determinant", study::json_number(matrix->determinant)},
          {"failure_rule_per_kPa", study::json_number(1e3 * matrix->failure_rule)}};
}

/// What is not answered is neither controllable nor not.
study::Json named_json(const sim::ControlIndex& at) {
  const bool known = at.answer.state != sim::ControlState::unanswered;
  return {{"name", at.name},
          {"controllable", known ? study::Json(at.answer.held()) : study::Json(nullptr)},
          {"index", study::json_number(at.answer.index)}};
}

study::Json closed_form_json(const std::optional<std::vector<sim::UnstableSector>>& sectors) {
  if (!sectors) return nullptr;
  study::Json cones = study::Json::array();
  for (const auto& sector : *sectors)
    cones.push_back(
        {{"from_deg", study::json_deg(sector.from)}, {"to_deg", study::json_deg(sector.to)}});
  return cones;
}

study::Json first_json(const std::optional<study::FirstUnstable>& first) {
  if (!first) return nullptr;
  return {{"p_eff_kPa", study::json_kPa(first->p)},
          {"q_kPa", study::json_kPa(first->q)},
          {"eta", study::json_number(first->eta())},
          {"void_ratio", study::json_number(first->void_ratio)},
          {"axial_strain", study::json_number(first->axial_strain)},
          {"alpha_deg", study::json_deg(first->angle)}};
}

study::Json control_json(const study::Controllability& control) {
  study::Json scan = study::Json::array(), lost = study::Json::array(),
              named = study::Json::array(), roots = study::Json::array(),
              conditions = study::Json::array();
  for (const auto& at : control.scan)
    scan.push_back({{"R", at.R},
                    {"controllable", at.controllable},
                    {"index", study::json_number(at.index)},
                    {"loading", answer_json(at.loading)},
                    {"unloading", answer_json(at.unloading)},
                    {"mode_alpha_deg",
                     at.mode.answered ? study::json_deg(at.mode.angle) : study::Json(nullptr)},
                    {"mode_w2_normalised", normalised(at.mode)},
                    {"matrix", matrix_json(at.matrix)}});
  for (const auto& range : control.lost)
    lost.push_back(
        {{"sense", sense_words(range.sense)},
         {"from_R", range.begins ? study::json_number(range.from) : study::Json(nullptr)},
         {"to_R", range.ends ? study::json_number(range.to) : study::Json(nullptr)}});
  for (const auto& at : control.named) named.push_back(named_json(at));
  for (const auto& at : control.conditions) {
    conditions.push_back(named_json(at));
    conditions.back()["limiting_variable"] = study::json_text(at.limiting_variable);
  }
  for (const auto& [root, compliance] : control.roots)
    roots.push_back({{"R", study::json_number(root.R)},
                     {"alpha_deg", study::json_deg(root.angle)},
                     {"failure_rule_per_kPa", study::json_number(1e3 * root.failure_rule)},
                     {"w2_normalised", study::json_number(root.normalised)},
                     {"compliance", compliance}});
  const auto& determinant = control.symmetric_determinant;
  return {{"by", "rate"},
          {"scan", std::move(scan)},
          {"searched_R", {study::kLeastRatio, study::kLargestRatio}},
          {"unanswered_controls", control.unanswered},
          {"lost", std::move(lost)},
          {"named", std::move(named)},
          {"conditions", std::move(conditions)},
          {"compliance", study::json_text(control.compliance)},
          {"symmetric_determinant_per_kPa2",
           study::json_number(determinant ? std::optional(1e6 * *determinant) : std::nullopt)},
          {"roots", std::move(roots)}};
}

/// Everything that is said of one state, put into `object`.
void put_state(const study::ProbeResult& result, const study::ProbedState& state,
               study::Json& object) {
  const study::Probing& probing = result.probing;
  object["state"] = state_json(state);
  study::Json cones = study::Json::array(), probes = study::Json::array();
  for (const sim::Cone& cone : state.circle.cones) cones.push_back(cone_json(cone));
  object["cones"] = std::move(cones);
  object["cones_closed_form"] = closed_form_json(state.closed_form);
  const sim::Probe& least = state.circle.least;
  object["least"] = {
      {"alpha_deg", least.answered ? study::json_deg(least.angle) : study::Json(nullptr)},
      {"w2_normalised", normalised(least)}};
  const sim::Probe& unloading = state.isotropic_unloading;
  object["isotropic_unloading"] = {
      {"alpha_deg", study::json_deg(unloading.angle)},
      {"by",
       probing.finite && probing.kind == sim::ProbeKind::stress ? "integrated increment" : "rate"},
      {"w2_normalised", normalised(unloading)},
      {"in_cone", unloading.answered ? study::Json(unloading.normalised < sim::kUnstable)
                                     : study::Json(nullptr)}};
  object["own_increment"] = own_json(state, probing);
  object["control"] = control_json(state.control);
  object["unanswered_directions"] = state.circle.unanswered;
  object["refused_directions"] = state.circle.refused;
  object["refusal"] = study::json_text(state.refusal);
  for (const sim::Probe& probe : state.circle.probes) probes.push_back(probe_json(probe, probing));
  object["probes"] = std::move(probes);
}

}  // namespace

std::string probe_json(const study::ProbeResult& result) {
  study::Json document = {{"origin", "simulated"},
                          {"material", study::json_material(result.material)},
                          {"probing", probing_json(result.probing)},
                          {"path", study::json_text(result.path)}};
  study::Json warnings = result.warnings;
  if (!result.many && result.states.size() == 1) {
    const study::ProbedState& state = result.states.front();
    put_state(result, state, document);
    for (const auto& warning : state.all_warnings()) warnings.push_back(warning);
  } else {
    study::Json states = study::Json::array();
    for (const study::ProbedState& state : result.states) {
      study::Json one = study::Json::object();
      put_state(result, state, one);
      one["warnings"] = state.all_warnings();
      states.push_back(std::move(one));
    }
    document["states"] = std::move(states);
    if (result.has_first()) document["first_unstable_state"] = first_json(result.first_unstable());
  }
  document["warnings"] = std::move(warnings);
  return study::json_document(document);
}

}  // namespace triax::src
