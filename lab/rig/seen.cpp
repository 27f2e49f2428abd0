// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/seen.hpp"

#include <cmath>

namespace triax::lab {
namespace {

constexpr double kRateWindow_s = 30;
constexpr double kLeastCellStep_pa = 5e3;

}  // namespace

Seen::Seen(const RecordHeader& header) : reduction_(header, {}) {
  before_.fill(kMissing);
  now_.fill(kMissing);
}

void Seen::take(const Reading& reading) {
  Reading known = reading;
  for (std::size_t i = 0; i < kRawQuantityCount; ++i)
    if (std::isnan(known.si[i])) known.si[i] = held_.si[i];
  held_ = known;
  state_ = reduction_.reduce(held_);
  take_area();
  count_rates();
  before_ = now_;
  now_ = values();
}

void Seen::take_area() {
  area_before_ = area_;
  leapt_ = !leapt_ && std::fabs(state_.area_m2 - area_) > kLeap * area_;
  if (!leapt_) area_ = state_.area_m2;
}

void Seen::begin_stage() {
  stage_time_s_ = 0;
  mark_ = {};
  volume_rate_ = axial_rate_ = kMissing;
  cell_at_start_ = held_[Quantity::cell_pressure];
  pore_at_start_ = held_[Quantity::pore_pressure];
  before_.fill(kMissing);
  now_ = values();
}

void Seen::count_rates() {
  const Mark here{held_.time_s, held_[Quantity::back_volume], held_[Quantity::axial_displacement]};
  const double lapse = here.time_s - mark_.time_s;
  if (lapse < kRateWindow_s) return;
  if (!std::isnan(lapse)) {
    volume_rate_ = std::fabs(here.volume - mark_.volume) / lapse;
    axial_rate_ = std::fabs(here.displacement - mark_.displacement) / lapse;
  }
  mark_ = here;
}

double Seen::next_area_m2() const {
  const double change = area_ - area_before_;
  return std::isnan(change) ? area_ : area_ + change;
}

Seen::Values Seen::values() const {
  const double cell_step = held_[Quantity::cell_pressure] - cell_at_start_;
  Values v;
  const auto set = [&v](EndQuantity quantity, double value) {
    v[static_cast<std::size_t>(quantity)] = value;
  };
  using enum EndQuantity;
  set(time, stage_time_s_);
  set(cell_pressure, held_[Quantity::cell_pressure]);
  set(back_pressure, held_[Quantity::back_pressure]);
  set(pore_pressure, held_[Quantity::pore_pressure]);
  set(pore_pressure_lag,
      std::fabs(held_[Quantity::pore_pressure] - held_[Quantity::back_pressure]));
  set(deviator_stress, state_.q);
  set(mean_effective_stress, state_.p_eff);
  set(stress_ratio, state_.eta());
  set(axial_strain, state_.strain.axial);
  set(volumetric_strain, state_.volumetric_strain);
  set(axial_displacement, held_[Quantity::axial_displacement]);
  set(axial_force, held_[Quantity::axial_force]);
  set(effective_axial_stress, state_.effective_stress.axial);
  set(effective_radial_stress, state_.effective_stress.radial);
  set(void_ratio, state_.void_ratio);
  set(back_volume, held_[Quantity::back_volume]);
  set(volume_rate, volume_rate_);
  set(axial_rate, axial_rate_);
  set(b_value, std::fabs(cell_step) < kLeastCellStep_pa
                   ? kMissing
                   : (held_[Quantity::pore_pressure] - pore_at_start_) / cell_step);
  return v;
}

double Seen::value(EndQuantity quantity) const {
  if (quantity == EndQuantity::time) return stage_time_s_;
  return now_[static_cast<std::size_t>(quantity)];
}

bool Seen::met(const EndCondition& end) const {
  if (!end.met(value(end.quantity))) return false;
  return end.quantity == EndQuantity::time ||
         end.met(before_[static_cast<std::size_t>(end.quantity)]);
}

}  // namespace triax::lab
