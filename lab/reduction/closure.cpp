// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/closure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace triax::lab {
namespace {

/// What a computed column of that quantity says, by our own reduction.
struct Pair {
  CheckKind kind;
  Quantity quantity;
  double (*ours)(const State&);
};

constexpr auto kPairs = std::to_array<Pair>({
    {CheckKind::closure_deviator_stress, Quantity::deviator_stress,
     [](const State& s) { return s.q; }},
    {CheckKind::closure_mean_effective_stress, Quantity::mean_effective_stress,
     [](const State& s) { return s.p_eff; }},
    {CheckKind::closure_effective_axial_stress, Quantity::effective_axial_stress,
     [](const State& s) { return s.effective_stress.axial; }},
    {CheckKind::closure_effective_radial_stress, Quantity::effective_radial_stress,
     [](const State& s) { return s.effective_stress.radial; }},
    {CheckKind::closure_axial_strain, Quantity::axial_strain,
     [](const State& s) { return s.strain.axial; }},
    {CheckKind::closure_volumetric_strain, Quantity::volumetric_strain,
     [](const State& s) { return s.volumetric_strain; }},
    {CheckKind::closure_void_ratio, Quantity::void_ratio,
     [](const State& s) { return s.void_ratio; }},
    {CheckKind::closure_current_area, Quantity::current_area,
     [](const State& s) { return s.area_m2; }},
});

}  // namespace

void Closure::add(const Reading& reading, const State& state, bool in_shear) {
  if (!in_shear) return;
  for (const Pair& pair : kPairs) {
    const double theirs = reading[pair.quantity];
    const double ours = pair.ours(state);
    if (std::isnan(theirs) || std::isnan(ours)) continue;
    Sums& sums = sums_[index(pair.quantity)];
    sums.ours_theirs += ours * theirs;
    sums.ours_ours += ours * ours;
    ++sums.count;
  }
  const double their_area = reading[Quantity::current_area];
  if (!(their_area > 0)) return;
  if (!their_start_area_) their_start_area_ = their_area;
  area_ratio_sum_ += their_area / state.area_m2;
  ++area_count_;
}

std::vector<Check> Closure::checks(std::optional<double> start_area,
                                   bool back_volume_joined) const {
  std::vector<Check> all;
  for (const Pair& pair : kPairs) {
    const Sums& sums = sums_[index(pair.quantity)];
    if (sums.count == 0 || !(sums.ours_ours > 0)) continue;
    const double difference = 1 - sums.ours_theirs / sums.ours_ours;
    Check check{.kind = pair.kind,
                .measured = difference,
                .limit = kLimit,
                .ok = std::fabs(difference) <= kLimit};
    check.note = fmt::format("the {} in the file is {:.2f} % {} than the value of triax",
                             info(pair.quantity).symbol, std::fabs(difference) * 100,
                             difference < 0 ? "higher" : "lower");
    if (pair.quantity == Quantity::deviator_stress && !check.ok && area_count_ > 0 && start_area)
      check.note += area_as_cause(difference, *start_area, back_volume_joined);
    all.push_back(std::move(check));
  }
  return all;
}

std::string Closure::area_as_cause(double difference, double start_area,
                                   bool back_volume_joined) const {
  const double area_ratio = area_ratio_sum_ / static_cast<double>(area_count_);
  if (std::fabs(1 / area_ratio - 1 + difference) > 0.01) return {};
  std::string cause = fmt::format(
      ", because of the area: at the start of shear the file has {:.1f} mm2, triax {:.1f} mm2",
      *their_start_area_ * 1e6, start_area * 1e6);
  if (back_volume_joined)
    cause +=
        "; its volume counter was reset between stages, but the reference for the volume change "
        "was not";
  return cause;
}

}  // namespace triax::lab
