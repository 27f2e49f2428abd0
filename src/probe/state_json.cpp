// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/state_json.hpp"

#include <cmath>

namespace triax::src {
namespace {

std::optional<double> known(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

study::Json test_json(const study::TestedState& test) {
  const lab::State& s = test.state;
  return {{"id", test.id},
          {"name", test.name},
          {"origin", lab::to_string(test.origin)},
          {"at", test.at},
          {"reading", s.reading},
          {"time_s", test.has_time ? study::json_number(known(s.time_s)) : study::Json(nullptr)},
          {"axial_strain", study::json_number(known(s.strain.axial))}};
}

}  // namespace

study::Json state_json(const study::StateHead& state) {
  study::Json memory = study::Json::object();
  for (const auto& [name, value] : state.memory) memory[name] = study::json_number(value);
  const Eigen::Vector3d& s = state.stress;
  return {
      {"name", study::json_text(state.name)},
      {"p_eff_kPa", study::json_kPa(state.p)},
      {"q_kPa", study::json_kPa(state.q)},
      {"eta", study::json_number(state.eta())},
      {"void_ratio", study::json_number(state.void_ratio)},
      {"axial_stress_kPa", study::json_kPa(s(0))},
      {"radial_stress_kPa", s(1) == s(2) ? study::json_kPa(s(2)) : study::Json(nullptr)},
      {"principal_stresses_kPa",
       study::Json::array({study::json_kPa(s(0)), study::json_kPa(s(1)), study::json_kPa(s(2))})},
      {"axial_strain", study::json_number(state.axial_strain)},
      {"memory_from", state.from_path ? "path" : "start"},
      {"memory", std::move(memory)},
      {"test", state.test ? test_json(*state.test) : study::Json(nullptr)}};
}

}  // namespace triax::src
