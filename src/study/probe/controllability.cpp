// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/controllability.hpp"

#include <algorithm>
#include <numbers>
#include <variant>

#include "sim/stability/plane_rate.hpp"

namespace triax::study {
namespace {

using sim::Axisymmetric;
using sim::Tensor;

/// Of zone (−, −, −), which the moduli of the paper's equations belong to.
sim::PlaneCompliance zone_of(const sim::InterpolatedForm<Axisymmetric>& form) {
  return sim::plane_compliance(sim::zone_compliance(form, sim::ZoneSigns{}));
}
sim::PlaneCompliance zone_of(const sim::InterpolatedForm<Tensor>& form) {
  return sim::plane_compliance(sim::principal_moduli(sim::zone_compliance(form, sim::ZoneSigns{})));
}

template <class Space>
std::optional<sim::PlaneCompliance> compliance_of(const sim::IncrementalResponse<Space>& response,
                                                  const sim::Probe& least, std::string& whose) {
  const auto form = response.law().response(response.state());
  if (const auto* interpolated = std::get_if<sim::InterpolatedForm<Space>>(&form)) {
    whose = interpolated->quadratic ? "zone (-, -) of the octolinear law with these moduli"
                                    : "zone (-, -)";
    return zone_of(*interpolated);
  }
  if (!least.answered) return std::nullopt;
  const auto rate = sim::stress_rate(response, sim::angle_of(least.stress));
  if (!rate.controllable) return std::nullopt;
  whose = "tangent of the least direction";
  return sim::plane_compliance(response, rate);
}

}  // namespace

std::vector<double> usual_ratios() {
  std::vector<double> ratios;
  for (int i = 1; i <= 30; ++i) ratios.push_back(i / 10.0);
  return ratios;
}

std::vector<sim::LostControl> lost_of_either_sense(const Controllability& control) {
  auto ranges = control.lost;
  std::ranges::sort(ranges, {}, &sim::LostControl::from);
  std::vector<sim::LostControl> apart;
  for (const auto& range : ranges) {
    if (apart.empty() || range.from > apart.back().to) {
      apart.push_back(range);
    } else if (range.to > apart.back().to) {
      apart.back().to = range.to;
      apart.back().ends = range.ends;
    }
  }
  return apart;
}

template <class Space>
Controllability control_of(const sim::IncrementalResponse<Space>& response, const sim::Probe& least,
                           const std::vector<double>& R,
                           const std::vector<sim::NamedControl>& conditions) {
  Controllability found;
  found.scan = sim::scan_control(response, R);
  auto search = sim::lost_control(response, kLeastRatio, kLargestRatio);
  found.lost = std::move(search.lost);
  found.asked = search.asked;
  found.unanswered = search.unanswered;
  if constexpr (Space::kSize == 2) {
    found.named = sim::control_indices(response, sim::triaxial_controls());
    found.conditions = sim::control_indices(response, conditions);
  }
  const auto compliance = compliance_of(response, least, found.compliance);
  if (!compliance) {
    found.compliance.clear();
    return found;
  }
  found.symmetric_determinant = compliance->symmetric_determinant();
  for (const double root : sim::control_quadratic(*compliance).roots())
    found.roots.push_back({root, sim::failure_angle(compliance->plane, root) + std::numbers::pi,
                           sim::failure_rule(*compliance, root)});
  return found;
}

template Controllability control_of(const sim::IncrementalResponse<Axisymmetric>&,
                                    const sim::Probe&, const std::vector<double>&,
                                    const std::vector<sim::NamedControl>&);
template Controllability control_of(const sim::IncrementalResponse<Tensor>&, const sim::Probe&,
                                    const std::vector<double>&,
                                    const std::vector<sim::NamedControl>&);

}  // namespace triax::study
