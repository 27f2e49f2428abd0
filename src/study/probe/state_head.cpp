// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/state_head.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/base/bad_input.hpp"

namespace triax::study {
namespace {

Eigen::Vector3d principal(const sim::Vector<sim::Axisymmetric>& v) {
  const auto s = sim::axisymmetric_stress(v);
  return {s.axial, s.radial, s.radial};
}
Eigen::Vector3d principal(const sim::Vector<sim::Tensor>& v) { return v.head<3>(); }

template <class Space>
std::string words(const sim::PointState<Space>& state) {
  const double p = state.p(), q = deviator_stress(state);
  return fmt::format("p' {:.6g} kPa, q {:.6g} kPa, void ratio {:.6g}", p / 1e3, q / 1e3,
                     state.void_ratio);
}

}  // namespace

template <class Space>
double deviator_stress(const sim::PointState<Space>& state) {
  const Eigen::Vector3d s = principal(state.stress);
  return std::copysign(std::abs(state.q()), s(0) - (s(1) + s(2)) / 2);
}

std::vector<std::string> StateHead::all_warnings() const {
  std::vector<std::string> all = warnings;
  for (const auto& words : {void_ratio_outside, p_eff_outside})
    if (words) all.push_back(*words);
  return all;
}

std::vector<std::string> warnings_of(const std::vector<const StateHead*>& states) {
  std::vector<std::string> all;
  for (const StateHead* state : states)
    for (const auto& warning : state->warnings)
      if (std::ranges::find(all, warning) == all.end()) all.push_back(warning);
  for (const auto outside : {&StateHead::void_ratio_outside, &StateHead::p_eff_outside}) {
    const auto is_outside = [&](const StateHead* s) { return (s->*outside).has_value(); };
    const auto first = std::ranges::find_if(states, is_outside);
    if (first == states.end()) continue;
    const auto more = std::ranges::count_if(states, is_outside) - 1;
    all.push_back(*((*first)->*outside) +
                  (more > 0 ? fmt::format(", and so at {} more of the states", more) : ""));
  }
  return all;
}

template <class Space>
StateHead head_of(const lab::MaterialSet& material, const StateToProbe<Space>& what) {
  const sim::Law<Space>& law = *material.material.law<Space>();
  const sim::PointState<Space>& state = what.state;
  if (const auto objection = law.objection(state))
    throw lab::BadInput(fmt::format("{}{}: out of range for {}: {}",
                                    what.name.empty() ? "" : what.name + ", ", words(state),
                                    material.name, *objection));
  StateHead head{.name = what.name,
                 .from_path = what.from_path,
                 .axial_strain = what.axial_strain,
                 .stress = principal(state.stress),
                 .p = state.p(),
                 .q = deviator_stress(state),
                 .void_ratio = state.void_ratio,
                 .memory = {},
                 .test = what.test,
                 .warnings = {},
                 .void_ratio_outside = lab::void_ratio_outside(material, state.void_ratio),
                 .p_eff_outside = lab::p_eff_outside(material, state.p())};
  if (auto warning = law.warning(state)) head.warnings.push_back(std::move(*warning));
  if (what.test)
    head.warnings.insert(head.warnings.end(), what.test->warnings.begin(),
                         what.test->warnings.end());
  const auto names = law.memory_names();
  for (std::size_t i = 0; i < names.size() && static_cast<Eigen::Index>(i) < state.memory.size();
       ++i)
    head.memory.emplace_back(names[i], state.memory(static_cast<Eigen::Index>(i)));
  return head;
}

template StateHead head_of(const lab::MaterialSet&, const StateToProbe<sim::Axisymmetric>&);
template StateHead head_of(const lab::MaterialSet&, const StateToProbe<sim::Tensor>&);
template double deviator_stress(const sim::PointState<sim::Axisymmetric>&);
template double deviator_stress(const sim::PointState<sim::Tensor>&);

}  // namespace triax::study
