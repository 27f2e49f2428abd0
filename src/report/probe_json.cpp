// The JSON form of a report of probes.
#include <cmath>

#include "src/report/json_parts.hpp"
#include "src/report/probe_report.hpp"
#include "src/report/state_json.hpp"

namespace triax::src {
namespace {

constexpr bool axisymmetric(const Probing& probing) {
  return probing.plane == sim::ProbePlane::axisymmetric;
}

Json normalised(const sim::Probe& probe) {
  return probe.answered ? json_number(probe.normalised) : Json(nullptr);
}

Json probing_json(const Probing& probing) {
  const bool stress = probing.kind == sim::ProbeKind::stress;
  return {{"kind", stress ? "stress" : "strain"},
          {"plane", axisymmetric(probing) ? "axisymmetric" : "plane-strain"},
          {"norm_kPa", stress ? json_kPa(probing.norm) : Json(nullptr)},
          {"norm_strain", stress ? Json(nullptr) : Json(probing.norm)},
          {"step_deg", probing.step_deg()},
          {"finite", probing.finite},
          {"norms", axisymmetric(probing) ? "full" : "plane"}};
}

Json increment_json(const sim::PlaneVector& v, const Probing& probing, double unit,
                    const std::string& suffix) {
  const double lateral = axisymmetric(probing) ? v.x() / std::numbers::sqrt2 : v.x();
  return {{"axial" + suffix, json_number(v.y() / unit)},
          {(axisymmetric(probing) ? "radial" : "lateral") + suffix, json_number(lateral / unit)}};
}

Json probe_json(const sim::Probe& probe, const Probing& probing) {
  Json one = {{"alpha_deg", json_deg(probe.angle)}, {"w2_normalised", normalised(probe)}};
  one["w2_Pa"] = probe.answered ? json_number(probe.second_order_work) : Json(nullptr);
  one["stress"] =
      probe.answered ? increment_json(probe.stress, probing, 1e3, "_kPa") : Json(nullptr);
  one["strain"] = probe.answered ? increment_json(probe.strain, probing, 1, "") : Json(nullptr);
  one["answered"] = probe.answered;
  return one;
}

Json cone_json(const sim::Cone& cone) {
  return {{"from_deg", json_deg(cone.from)},
          {"to_deg", json_deg(cone.to)},
          {"opening_deg", json_deg(cone.opening())},
          {"strongest_deg", json_deg(cone.strongest.angle)},
          {"w2_normalised_least", normalised(cone.strongest)}};
}

/// Null for a state that no test was in, or whose increment is not known.
Json own_json(const ProbedState& state, const Probing& probing) {
  if (!state.test || !state.test->increment) return nullptr;
  const lab::MeasuredIncrement& own = *state.test->increment;
  const bool comparable = state.own && probing.kind == sim::ProbeKind::stress;
  Json own_json = {{"alpha_deg", json_deg(own.angle)},
                   {"alpha_error_deg", json_deg(own.angle_error)},
                   {"w2_normalised_measured", json_number(own.normalised)},
                   {"w2_normalised_error", json_number(own.normalised_error)},
                   {"window_readings", own.window_readings},
                   {"w2_normalised_law", state.own ? normalised(*state.own) : Json(nullptr)},
                   {"in_cone", comparable ? Json(false) : Json(nullptr)},
                   {"certain", nullptr},
                   {"cone", nullptr},
                   {"nearest_edge_deg", nullptr}};
  if (!comparable) return own_json;
  if (const auto place = place_among(state.circle.cones, own.angle)) {
    own_json["in_cone"] = place->inside;
    own_json["certain"] = place->certain(own.angle_error);
    own_json["cone"] = place->cone;
    own_json["nearest_edge_deg"] = json_deg(place->to_edge);
  }
  return own_json;
}

Json answer_json(const sim::ControlAnswer& answer) {
  return {{"control", state_name(answer.state)}, {"index", json_number(answer.index)}};
}

/// Eq. (32) or (33), from (dε₁, dσ₃/R) to (dσ₁ − dσ₃/R, dε₁ + 2R dε₃ or dε₁ + R dε₃), in kPa.
Json matrix_json(const std::optional<sim::ControlMatrix>& matrix) {
  if (!matrix) return nullptr;
  const Eigen::Matrix2d& m = matrix->entries;
  return {{"stress_by_axial_strain_kPa", json_number(m(0, 0) / 1e3)},
          {"stress_by_radial_stress_over_R", json_number(m(0, 1))},
          {"strain_by_axial_strain", json_number(m(1, 0))},
          {"strain_by_radial_stress_over_R_per_kPa", json_number(1e3 * m(1, 1))},
          {"determinant", json_number(matrix->determinant)},
          {"failure_rule_per_kPa", json_number(1e3 * matrix->failure_rule)}};
}

/// What is not answered is neither controllable nor not.
Json named_json(const sim::ControlIndex& at) {
  const bool known = at.answer.state != sim::ControlState::unanswered;
  return {{"name", at.name},
          {"controllable", known ? Json(at.answer.held()) : Json(nullptr)},
          {"index", json_number(at.answer.index)}};
}

Json closed_form_json(const std::optional<std::vector<sim::UnstableSector>>& sectors) {
  if (!sectors) return nullptr;
  Json cones = Json::array();
  for (const auto& sector : *sectors)
    cones.push_back({{"from_deg", json_deg(sector.from)}, {"to_deg", json_deg(sector.to)}});
  return cones;
}

Json first_json(const std::optional<FirstUnstable>& first) {
  if (!first) return nullptr;
  return {{"p_eff_kPa", json_kPa(first->p)},
          {"q_kPa", json_kPa(first->q)},
          {"eta", json_number(first->eta())},
          {"void_ratio", json_number(first->void_ratio)},
          {"axial_strain", json_number(first->axial_strain)},
          {"alpha_deg", json_deg(first->angle)}};
}

Json control_json(const ControlReport& control) {
  Json scan = Json::array(), lost = Json::array(), named = Json::array(), roots = Json::array(),
       conditions = Json::array();
  for (const auto& at : control.scan)
    scan.push_back({{"R", at.R},
                    {"controllable", at.controllable},
                    {"index", json_number(at.index)},
                    {"loading", answer_json(at.loading)},
                    {"unloading", answer_json(at.unloading)},
                    {"mode_alpha_deg", at.mode.answered ? json_deg(at.mode.angle) : Json(nullptr)},
                    {"mode_w2_normalised", normalised(at.mode)},
                    {"matrix", matrix_json(at.matrix)}});
  for (const auto& range : control.lost)
    lost.push_back({{"sense", sense_words(range.sense)},
                    {"from_R", range.begins ? json_number(range.from) : Json(nullptr)},
                    {"to_R", range.ends ? json_number(range.to) : Json(nullptr)}});
  for (const auto& at : control.named) named.push_back(named_json(at));
  for (const auto& at : control.conditions) {
    conditions.push_back(named_json(at));
    conditions.back()["culprit"] = json_text(at.culprit);
  }
  for (const auto& root : control.roots)
    roots.push_back({{"R", json_number(root.R)},
                     {"alpha_deg", json_deg(root.angle)},
                     {"failure_rule_per_kPa", json_number(1e3 * root.failure_rule)}});
  const auto& determinant = control.symmetric_determinant;
  return {{"by", "rate"},
          {"scan", std::move(scan)},
          {"searched_R", {kLeastRatio, kLargestRatio}},
          {"unanswered_controls", control.unanswered},
          {"lost", std::move(lost)},
          {"named", std::move(named)},
          {"conditions", std::move(conditions)},
          {"compliance", json_text(control.compliance)},
          {"symmetric_determinant_per_kPa2",
           json_number(determinant ? std::optional(1e6 * *determinant) : std::nullopt)},
          {"roots", std::move(roots)}};
}

/// Everything that is said of one state, put into `object`.
void put_state(const ProbeReport& report, const ProbedState& state, Json& object) {
  const Probing& probing = report.probing;
  object["state"] = state_json(state);
  Json cones = Json::array(), probes = Json::array();
  for (const sim::Cone& cone : state.circle.cones) cones.push_back(cone_json(cone));
  object["cones"] = std::move(cones);
  object["cones_closed_form"] = closed_form_json(state.closed_form);
  const sim::Probe& least = state.circle.least;
  object["least"] = {{"alpha_deg", least.answered ? json_deg(least.angle) : Json(nullptr)},
                     {"w2_normalised", normalised(least)}};
  const sim::Probe& unloading = state.isotropic_unloading;
  object["isotropic_unloading"] = {
      {"alpha_deg", json_deg(unloading.angle)},
      {"by",
       probing.finite && probing.kind == sim::ProbeKind::stress ? "integrated increment" : "rate"},
      {"w2_normalised", normalised(unloading)},
      {"in_cone",
       unloading.answered ? Json(unloading.normalised < sim::kUnstable) : Json(nullptr)}};
  object["own_increment"] = own_json(state, probing);
  object["control"] = control_json(state.control);
  object["unanswered_directions"] = state.circle.unanswered;
  object["refused_directions"] = state.circle.refused;
  object["refusal"] = json_text(state.refusal);
  for (const sim::Probe& probe : state.circle.probes) probes.push_back(probe_json(probe, probing));
  object["probes"] = std::move(probes);
}

}  // namespace

std::string probe_json(const ProbeReport& report) {
  Json document = {{"origin", "simulated"},
                   {"material", json_material(report.material)},
                   {"probing", probing_json(report.probing)},
                   {"path", json_text(report.path)}};
  Json warnings = report.warnings;
  if (!report.many && report.states.size() == 1) {
    const ProbedState& state = report.states.front();
    put_state(report, state, document);
    for (const auto& warning : state.all_warnings()) warnings.push_back(warning);
  } else {
    Json states = Json::array();
    for (const ProbedState& state : report.states) {
      Json one = Json::object();
      put_state(report, state, one);
      one["warnings"] = state.all_warnings();
      states.push_back(std::move(one));
    }
    document["states"] = std::move(states);
    if (report.has_first()) document["first_unstable_state"] = first_json(report.first_unstable());
  }
  document["warnings"] = std::move(warnings);
  return json_document(document);
}

}  // namespace triax::src
