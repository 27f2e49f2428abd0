// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/truth_watch.hpp"

#include <algorithm>
#include <cmath>

#include "sim/mechanics/second_order_work.hpp"

namespace triax::lab {

Truth lost_equilibrium(double time_s, const sim::SpecimenState& state, double height_at_shear_m) {
  Truth truth;
  truth.lost_sustainability = true;
  truth.time_s = time_s;
  truth.axial_strain = 1 - state.height_m / height_at_shear_m;
  truth.q_pa = state.material.q();
  truth.p_eff_pa = state.material.p();
  truth.pore_pressure_pa = state.pore_pressure;
  return truth;
}

bool fell(const sim::SpecimenState& state) {
  const sim::RunAway& last = state.run_away;
  if (last.count == 0 || last.end == sim::RunAway::End::arrested) return false;
  return last.end == sim::RunAway::End::end_of_travel ||
         std::fabs(state.height_m / last.start_height_m - 1) >= kLeastFall;
}

Truth earlier_of(const Truth& by_work, const Truth& by_fall) {
  if (!by_work.lost_sustainability) return by_fall;
  const bool later = *by_work.time_s > *by_fall.time_s &&
                     std::fabs(*by_work.axial_strain - *by_fall.axial_strain) >= kLeastFall;
  return later ? by_fall : by_work;
}

void TruthWatch::open(const Middle& now, double height_at_shear_m) {
  const bool turned = last_ && last_->work > 0;
  const double time_s =
      turned ? last_->time_s + (now.time_s - last_->time_s) * last_->work / (last_->work - now.work)
             : now.time_s - now.dt_s / 2;
  const double start_s = now.time_s - now.dt_s / 2;
  const Middle& in = turned && time_s < start_s ? *last_ : now;
  const double x = std::clamp((time_s - (in.time_s - in.dt_s / 2)) / in.dt_s, 0.0, 1.0);
  const auto at = [x](double a, double b) { return a + x * (b - a); };
  truth_.lost_sustainability = true;
  truth_.time_s = time_s;
  truth_.axial_strain = 1 - at(in.before.height_m, in.after.height_m) / height_at_shear_m;
  truth_.q_pa = at(in.before.material.q(), in.after.material.q());
  truth_.p_eff_pa = at(in.before.material.p(), in.after.material.p());
  truth_.pore_pressure_pa = at(in.before.pore_pressure, in.after.pore_pressure);
}

void TruthWatch::watch(double time_s, double dt_s, const sim::SpecimenState& before,
                       const sim::SpecimenStep& step, bool shear, double height_at_shear_m) {
  if (confirmed_) return;
  if (!shear) {
    last_.reset();
    sum_.reset();
    pending_ = false;
    return;
  }
  if (!sum_) sum_ = Sum{.start_s = time_s, .before = before, .stress = {}, .strain = {}};
  sum_->dt_s += dt_s;
  sum_->stress.axial += step.stress_increment.axial;
  sum_->stress.radial += step.stress_increment.radial;
  sum_->strain.axial += step.strain_increment.axial;
  sum_->strain.radial += step.strain_increment.radial;
  const auto& d = step.strain_increment;
  sum_->path += std::sqrt(d.axial * d.axial + 2 * d.radial * d.radial);
  if (sum_->path < lengths_.increment) return;

  const auto de = sum_->strain;
  const double work = sim::second_order_work({}, sum_->stress, de).normalised;
  const Middle now{sum_->start_s + sum_->dt_s / 2, work, sum_->before, step.state, sum_->dt_s};
  sum_.reset();
  if (work >= 0) {
    pending_ = false;
  } else {
    if (!pending_) {
      pending_ = true;
      path_ = 0;
      open(now, height_at_shear_m);
    }
    path_ += std::sqrt(de.axial * de.axial + 2 * de.radial * de.radial);
    confirmed_ = path_ >= lengths_.lasting;
  }
  last_ = now;
}

}  // namespace triax::lab
