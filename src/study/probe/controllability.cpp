// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/controllability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "sim/stability/plane_rate.hpp"

namespace triax::study {
namespace {

using sim::Axisymmetric;
using sim::Tensor;

std::string zone_words(const sim::InterpolatedForm<Axisymmetric>&, const sim::ZoneSigns& signs) {
  const auto sign = [&signs](std::size_t i) { return signs.loading[i] ? "+" : "-"; };
  return fmt::format("zone ({}, {})", sign(0), sign(2));
}
std::string zone_words(const sim::InterpolatedForm<Tensor>&, const sim::ZoneSigns& signs) {
  const auto sign = [&signs](std::size_t i) { return signs.loading[i] ? "+" : "-"; };
  return fmt::format("zone ({}, {}, {})", sign(0), sign(1), sign(2));
}

/// By the moduli of all zones.
template <class Space>
void put_roots(const sim::InterpolatedForm<Space>& form, Controllability& found) {
  const auto words = [&form](const sim::ZoneSigns& signs) {
    return zone_words(form, signs) +
           (form.quadratic ? " of the octolinear law with these moduli" : "");
  };
  const auto zones = sim::octolinear_zones(form);
  found.by_zones = true;
  if (zones.empty()) return;
  const sim::OctolinearZone& weakest = sim::weakest_zone(zones);
  found.compliance = words(weakest.signs);
  found.symmetric_determinant = weakest.compliance.symmetric_determinant();
  for (const sim::ControlRoot& root : sim::control_roots(zones))
    found.roots.push_back({root, words(*root.zone)});
}

/// By tangents.
template <class Space>
void put_roots(const sim::IncrementalResponse<Space>& response, const sim::Probe& least,
               Controllability& found) {
  if (!least.answered) return;
  const auto rate = sim::stress_rate(response, sim::angle_of(least.stress));
  if (!rate.controllable) return;
  const auto compliance = sim::plane_compliance(response, rate);
  if (!compliance) return;
  found.compliance = "tangent of the least direction";
  found.symmetric_determinant = compliance->symmetric_determinant();
  for (const sim::ControlRoot& root : sim::control_roots(response))
    found.roots.push_back({root, "tangent of its own direction"});
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
  const auto form = response.law().response(response.state());
  if (const auto* interpolated = std::get_if<sim::InterpolatedForm<Space>>(&form))
    put_roots(*interpolated, found);
  else
    put_roots(response, least, found);
  return found;
}

template Controllability control_of(const sim::IncrementalResponse<Axisymmetric>&,
                                    const sim::Probe&, const std::vector<double>&,
                                    const std::vector<sim::NamedControl>&);
template Controllability control_of(const sim::IncrementalResponse<Tensor>&, const sim::Probe&,
                                    const std::vector<double>&,
                                    const std::vector<sim::NamedControl>&);

}  // namespace triax::study
