// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/controllability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "sim/stability/plane_rate.hpp"
#include "sim/stability/stability_determinant.hpp"

namespace triax::study {
namespace {

using sim::Axisymmetric;
using sim::Tensor;

template <class Space>
bool octolinear(const sim::IncrementalResponse<Space>& response) {
  const auto* form = std::get_if<sim::InterpolatedForm<Space>>(&response.response());
  return form != nullptr && !form->quadratic;
}

/// The zone of the stress increment in a direction, of an octolinear law.
template <class Space>
std::string zone_words(const sim::IncrementalResponse<Space>& response, double angle) {
  const auto signs = sim::zone_of(sim::stress_rate(response, angle).stress);
  const auto sign = [&signs](std::size_t i) { return signs.loading[i] ? "+" : "-"; };
  return Space::kSize == 2 ? fmt::format("zone ({}, {})", sign(0), sign(2))
                           : fmt::format("zone ({}, {}, {})", sign(0), sign(1), sign(2));
}

/// Whose compliance the symmetric determinant of a direction is that of.
template <class Space>
std::string compliance_words(const sim::IncrementalResponse<Space>& response, double angle) {
  if (octolinear(response)) return zone_words(response, angle);
  return response.piecewise_linear() ? "tangent of the least direction"
                                     : "half the Hessian of W2 in the least direction";
}

template <class Space>
void put_determinant(const sim::IncrementalResponse<Space>& response, const sim::Probe& least,
                     Controllability& found) {
  const double angle = sim::angle_of(least.stress);
  const auto half_hessian = sim::half_hessian(response, angle);
  if (!half_hessian) return;
  found.compliance = compliance_words(response, angle);
  found.symmetric_determinant = half_hessian->determinant();
}

template <class Space>
void put_roots(const sim::IncrementalResponse<Space>& response, Controllability& found) {
  const auto [roots, unanswered] = sim::control_roots(response);
  found.unanswered_directions = unanswered;
  for (const sim::ControlRoot& root : roots)
    found.roots.push_back({root, octolinear(response) ? zone_words(response, root.angle)
                                                      : "tangent of its own direction"});
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
  // Where no probe was answered, to ask in every direction again would only take time.
  if (!least.answered) return found;
  put_determinant(response, least, found);
  put_roots(response, found);
  return found;
}

template Controllability control_of(const sim::IncrementalResponse<Axisymmetric>&,
                                    const sim::Probe&, const std::vector<double>&,
                                    const std::vector<sim::NamedControl>&);
template Controllability control_of(const sim::IncrementalResponse<Tensor>&, const sim::Probe&,
                                    const std::vector<double>&,
                                    const std::vector<sim::NamedControl>&);

}  // namespace triax::study
