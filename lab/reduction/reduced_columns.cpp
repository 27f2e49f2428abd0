// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/reduced_columns.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

/// The first of the values that is known.
double first_known(std::initializer_list<double> values) {
  for (const double value : values)
    if (!std::isnan(value)) return value;
  return kMissing;
}

/// a/b where that is a number.
double ratio(double a, double b) { return b != 0 ? a / b : kMissing; }

/// ε_v of a right cylinder whose height and diameter have shortened by these shares.
double volume_lost(double axial, double radial) {
  return 1 - (1 - axial) * (1 - radial) * (1 - radial);
}

}  // namespace

ReducedColumns::ReducedColumns(const RecordHeader& header) : stages_(header.stages) {
  using enum Quantity;
  void_ratio_start_ = header.specimen.consolidated_void_ratio
                          ? header.specimen.consolidated_void_ratio
                          : header.specimen.void_ratio;
  if (header.is_raw()) return;
  warnings_.push_back(
      {0, "the record has reduced stresses and strains, no raw channels: they are used unchanged"});
  const bool has_volume = header.has(volumetric_strain) || header.has(radial_strain) ||
                          header.has(shear_strain) || header.has(void_ratio);
  const bool closed = std::ranges::all_of(
      stages_, [](const StageInfo& s) { return s.drainage == Drainage::closed; });
  if (!has_volume && (stages_.empty() || !closed))
    warnings_.push_back({0,
                         "the record has no volume change: drained stages are assessed only "
                         "while σ₃′ is constant, all others are assumed undrained (ε_v = 0)"});
  only_excess_ = header.has(excess_pore_pressure) && !header.has(pore_pressure) &&
                 !header.has(axial_stress) && !header.has(radial_stress) &&
                 !header.has(cell_pressure);
  if (only_excess_)
    warnings_.push_back({0,
                         "the record has the excess pore pressure only: pore pressures are "
                         "relative to the start of shear"});
}

bool ReducedColumns::undrained(int stage) const {
  const auto info = std::ranges::find(stages_, stage, &StageInfo::number);
  return info == stages_.end() || info->drainage != Drainage::open;
}

void ReducedColumns::take_stresses(const Reading& r, State& s) const {
  using enum Quantity;
  const double total_radial = first_known({r[radial_stress], r[cell_pressure]});
  const double axial = first_known({r[effective_axial_stress], r[axial_stress] - r[pore_pressure]});
  const double radial = first_known({r[effective_radial_stress], total_radial - r[pore_pressure]});
  s.q = first_known({axial - radial, r[deviator_stress], r[axial_stress] - total_radial,
                     r[stress_ratio] * r[mean_effective_stress]});
  s.p_eff = first_known({(axial + 2 * radial) / 3, r[mean_effective_stress], radial + s.q / 3,
                         axial - 2 * s.q / 3, ratio(s.q, r[stress_ratio])});
  s.effective_stress = {s.p_eff + 2 * s.q / 3, s.p_eff - s.q / 3};
  s.pore_pressure = first_known({r[pore_pressure], total_radial - s.effective_stress.radial,
                                 r[axial_stress] - s.effective_stress.axial,
                                 only_excess_ ? r[excess_pore_pressure] : kMissing});
}

void ReducedColumns::take_strains(const Reading& r, State& s) {
  using enum Quantity;
  if (r.has(void_ratio) && !first_void_ratio_) first_void_ratio_ = r[void_ratio];
  if (!void_ratio_start_) void_ratio_start_ = first_void_ratio_;
  const double lost_voids = first_void_ratio_
                                ? (*first_void_ratio_ - r[void_ratio]) / (1 + *first_void_ratio_)
                                : kMissing;
  s.strain.axial = first_known({r[axial_strain], r[shear_strain] + r[volumetric_strain] / 3});
  s.volumetric_strain = first_known(
      {r[volumetric_strain], volume_lost(r[axial_strain], r[radial_strain]),
       3 * (r[axial_strain] - r[shear_strain]), lost_voids, undrained(r.stage) ? 0.0 : kMissing});
  s.strain.radial = (s.volumetric_strain - s.strain.axial) / 2;
  s.void_ratio = r[void_ratio];
  if (std::isnan(s.void_ratio) && void_ratio_start_)
    s.void_ratio = *void_ratio_start_ - s.volumetric_strain * (1 + *void_ratio_start_);
  if (r.has(current_area)) s.area_m2 = r[current_area];
}

State ReducedColumns::reduce(const Reading& r) {
  State s;
  s.reading = r.number;
  s.time_s = r.time_s;
  s.stage = r.stage;
  s.cycle = r[Quantity::cycle];
  take_stresses(r, s);
  take_strains(r, s);
  take_start(r, s);
  return s;
}

void ReducedColumns::take_start(const Reading& r, const State& s) {
  if (is_sheared_ || !std::isfinite(s.p_eff)) return;
  const auto info = std::ranges::find(stages_, r.stage, &StageInfo::number);
  is_sheared_ = info != stages_.end() && info->role == StageRole::shear;
  const bool follows_stages = is_sheared_ && p_eff_start_;
  if (!p_eff_start_ || is_sheared_) p_eff_start_ = s.p_eff;
  if (follows_stages && std::isfinite(s.void_ratio)) void_ratio_sheared_ = s.void_ratio;
}

Consolidation ReducedColumns::consolidation() const {
  return {.p_eff_pa = p_eff_start_,
          .b_value = {},
          .void_ratio = void_ratio_sheared_ ? void_ratio_sheared_ : void_ratio_start_,
          .height_m = {},
          .diameter_m = {}};
}

}  // namespace triax::lab
