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
          {"finite", probing.finite}};
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
  const auto place =
      comparable ? place_among(state.circle.cones, own.angle) : std::optional<ConePlace>();
  return {{"alpha_deg", json_deg(own.angle)},
          {"alpha_error_deg", json_deg(own.angle_error)},
          {"w2_normalised_measured", json_number(own.normalised)},
          {"w2_normalised_error", json_number(own.normalised_error)},
          {"window_readings", own.window_readings},
          {"w2_normalised_law", state.own ? normalised(*state.own) : Json(nullptr)},
          {"in_cone", comparable ? Json(place && place->inside) : Json(nullptr)},
          {"cone", place ? Json(place->cone) : Json(nullptr)},
          {"nearest_edge_deg", place ? json_deg(place->to_edge) : Json(nullptr)}};
}

Json control_json(const ControlReport& control) {
  Json scan = Json::array(), lost = Json::array(), named = Json::array(), roots = Json::array();
  for (const auto& at : control.scan)
    scan.push_back({{"R", at.R},
                    {"controllable", at.controllable},
                    {"index", json_number(at.index)},
                    {"mode_alpha_deg", at.mode.answered ? json_deg(at.mode.angle) : Json(nullptr)},
                    {"mode_w2_normalised", normalised(at.mode)}});
  for (const auto& range : control.lost)
    lost.push_back({{"from_R", range.begins ? json_number(range.from) : Json(nullptr)},
                    {"to_R", range.ends ? json_number(range.to) : Json(nullptr)}});
  for (const auto& at : control.named)
    named.push_back(
        {{"name", at.name}, {"controllable", at.controllable}, {"index", json_number(at.index)}});
  for (const auto& root : control.roots)
    roots.push_back({{"R", json_number(root.R)},
                     {"alpha_deg", json_deg(root.angle)},
                     {"failure_rule_per_kPa", json_number(1e3 * root.failure_rule)}});
  const auto& determinant = control.symmetric_determinant;
  return {{"scan", std::move(scan)},
          {"searched_R", {kLeastRatio, kLargestRatio}},
          {"lost", std::move(lost)},
          {"named", std::move(named)},
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
  const sim::Probe& least = state.circle.least;
  object["least"] = {{"alpha_deg", least.answered ? json_deg(least.angle) : Json(nullptr)},
                     {"w2_normalised", normalised(least)}};
  const sim::Probe& unloading = state.isotropic_unloading;
  object["isotropic_unloading"] = {
      {"alpha_deg", json_deg(unloading.angle)},
      {"w2_normalised", normalised(unloading)},
      {"in_cone",
       unloading.answered ? Json(unloading.normalised < sim::kUnstable) : Json(nullptr)}};
  object["own_increment"] = own_json(state, probing);
  object["control"] = control_json(state.control);
  object["unanswered_directions"] = state.circle.unanswered;
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
    const auto first = report.first_unstable();
    document["first_unstable_state"] = first ? Json(*first) : Json(nullptr);
  }
  document["warnings"] = std::move(warnings);
  return json_document(document);
}

}  // namespace triax::src
