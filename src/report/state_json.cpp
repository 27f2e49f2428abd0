#include "src/report/state_json.hpp"

#include <cmath>

namespace triax::src {
namespace {

std::optional<double> known(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Json test_json(const TestedState& test) {
  const lab::State& s = test.state;
  return {{"id", test.id},
          {"name", test.name},
          {"origin", lab::to_string(test.origin)},
          {"at", test.at},
          {"reading", s.reading},
          {"time_s", test.has_time ? json_number(known(s.time_s)) : Json(nullptr)},
          {"axial_strain", json_number(known(s.strain.axial))}};
}

}  // namespace

Json state_json(const StateHead& state) {
  Json memory = Json::object();
  for (const auto& [name, value] : state.memory) memory[name] = json_number(value);
  const Eigen::Vector3d& s = state.stress;
  return {{"name", json_text(state.name)},
          {"p_eff_kPa", json_kPa(state.p)},
          {"q_kPa", json_kPa(state.q)},
          {"eta", json_number(state.eta())},
          {"void_ratio", json_number(state.void_ratio)},
          {"axial_stress_kPa", json_kPa(s(0))},
          {"radial_stress_kPa", s(1) == s(2) ? json_kPa(s(2)) : Json(nullptr)},
          {"principal_stresses_kPa", Json::array({json_kPa(s(0)), json_kPa(s(1)), json_kPa(s(2))})},
          {"axial_strain", json_number(state.axial_strain)},
          {"memory_from", state.from_path ? "path" : "start"},
          {"memory", std::move(memory)},
          {"test", state.test ? test_json(*state.test) : Json(nullptr)}};
}

}  // namespace triax::src
