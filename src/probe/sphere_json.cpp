// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/sphere_json.hpp"

#include "src/probe/state_json.hpp"

namespace triax::src {
namespace {

study::Json vector_json(const Eigen::Vector3d& v, double unit) {
  return study::Json::array({study::json_number(v(0) / unit), study::json_number(v(1) / unit),
                             study::json_number(v(2) / unit)});
}

study::Json normalised(bool answered, double value) {
  return answered ? study::json_number(value) : study::Json(nullptr);
}

study::Json probe_json(const sim::SphereProbe& probe, const study::SphereProbing& probing) {
  const auto increment = study::increment_of(probe, probing);
  return {
      {"polar_deg", study::json_deg(probe.polar)},
      {"azimuth_deg", study::json_deg(probe.azimuth)},
      {"w2_normalised", normalised(probe.answered, probe.normalised)},
      {"w2_Pa", normalised(probe.answered, increment.second_order_work)},
      {"stress_kPa", probe.answered ? vector_json(increment.stress, 1e3) : study::Json(nullptr)},
      {"strain", probe.answered ? vector_json(increment.strain, 1) : study::Json(nullptr)},
      {"answered", probe.answered}};
}

/// Components 11, 22, 33, 12, 13, 23, the shear ones without the factor √2.
study::Json direction_json(const sim::FreeProbe& probe) {
  study::Json components = study::Json::array();
  for (Eigen::Index i = 0; i < 6; ++i)
    components.push_back(
        study::json_number(probe.direction(i) / (i < 3 ? 1 : std::numbers::sqrt2)));
  return components;
}

study::Json own_json(const study::ProbedSphere& state) {
  if (!state.own) return nullptr;
  const lab::MeasuredIncrement& own = *state.test->increment;
  return {{"alpha_deg", study::json_deg(own.angle)},
          {"alpha_error_deg", study::json_deg(own.angle_error)},
          {"polar_deg", study::json_deg(state.own->polar)},
          {"azimuth_deg", study::json_deg(state.own->azimuth)},
          {"w2_normalised_measured", study::json_number(own.normalised)},
          {"w2_normalised_error", study::json_number(own.normalised_error)},
          {"w2_normalised_law", normalised(state.own->answered, state.own->normalised)}};
}

void put_state(const study::SphereResult& result, const study::ProbedSphere& state,
               study::Json& object) {
  const sim::Sphere& sphere = state.sphere;
  object["state"] = state_json(state);
  object["least"] = {{"polar_deg", sphere.least.answered ? study::json_deg(sphere.least.polar)
                                                         : study::Json(nullptr)},
                     {"azimuth_deg", sphere.least.answered ? study::json_deg(sphere.least.azimuth)
                                                           : study::Json(nullptr)},
                     {"direction", sphere.least.answered ? vector_json(sphere.least.direction, 1)
                                                         : study::Json(nullptr)},
                     {"w2_normalised", normalised(sphere.least.answered, sphere.least.normalised)}};
  object["unstable_share"] = sphere.unstable_share;
  object["unstable_regions"] = sphere.regions;
  object["least_of_all_components"] = {
      {"direction", state.least.answered ? direction_json(state.least) : study::Json(nullptr)},
      {"w2_normalised", normalised(state.least.answered, state.least.normalised)}};
  object["own_increment"] = own_json(state);
  object["unanswered_directions"] = sphere.unanswered;
  study::Json probes = study::Json::array();
  for (const auto& probe : sphere.probes) probes.push_back(probe_json(probe, result.probing));
  object["probes"] = std::move(probes);
}

}  // namespace

std::string sphere_json(const study::SphereResult& result) {
  const bool stress = result.probing.kind == sim::ProbeKind::stress;
  study::Json document = {
      {"origin", "simulated"},
      {"material", study::json_material(result.material)},
      {"probing",
       {{"kind", stress ? "stress" : "strain"},
        {"plane", "3d"},
        {"norm_kPa", stress ? study::json_kPa(result.probing.norm) : study::Json(nullptr)},
        {"norm_strain", stress ? study::Json(nullptr) : study::Json(result.probing.norm)},
        {"step_deg", result.probing.step_deg()},
        {"finite", false},
        {"norms", "full"}}},
      {"path", study::json_text(result.path)}};
  study::Json warnings = result.warnings;
  if (!result.many && result.states.size() == 1) {
    put_state(result, result.states.front(), document);
    for (const auto& warning : result.states.front().all_warnings()) warnings.push_back(warning);
  } else {
    study::Json states = study::Json::array();
    for (const study::ProbedSphere& state : result.states) {
      study::Json one = study::Json::object();
      put_state(result, state, one);
      one["warnings"] = state.all_warnings();
      states.push_back(std::move(one));
    }
    document["states"] = std::move(states);
  }
  document["warnings"] = std::move(warnings);
  return study::json_document(document);
}

}  // namespace triax::src
