// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/truth_watch.hpp"

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

namespace {

bool slipped(const sim::SpecimenState& state) {
  const sim::RunAway& last = state.run_away;
  return last.end == sim::RunAway::End::arrested &&
         std::fabs(state.height_m / last.start_height_m - 1) < kLeastFall;
}

}  // namespace

Truth earlier_of(const Truth& by_work, const Truth& by_fall) {
  if (!by_work.lost_sustainability) return by_fall;
  const bool later = *by_work.time_s > *by_fall.time_s &&
                     std::fabs(*by_work.axial_strain - *by_fall.axial_strain) >= kLeastFall;
  return later ? by_fall : by_work;
}

void TruthWatch::open(const Middle& now, double height_at_shear_m) {
  const bool turned = now_.last && now_.last->work > 0;
  const double time_s = turned
                            ? now_.last->time_s + (now.time_s - now_.last->time_s) *
                                                      now_.last->work / (now_.last->work - now.work)
                            : now.time_s - now.dt_s / 2;
  const double start_s = now.time_s - now.dt_s / 2;
  const Middle& in = turned && time_s < start_s ? *now_.last : now;
  const double x = std::clamp((time_s - (in.time_s - in.dt_s / 2)) / in.dt_s, 0.0, 1.0);
  const auto at = [x](double a, double b) { return a + x * (b - a); };
  now_.truth.lost_sustainability = true;
  now_.truth.time_s = time_s;
  now_.truth.axial_strain = 1 - at(in.before.height_m, in.after.height_m) / height_at_shear_m;
  now_.truth.q_pa = at(in.before.material.q(), in.after.material.q());
  now_.truth.p_eff_pa = at(in.before.material.p(), in.after.material.p());
  now_.truth.pore_pressure_pa = at(in.before.pore_pressure, in.after.pore_pressure);
}

void TruthWatch::watch(double time_s, double dt_s, const sim::SpecimenState& before,
                       const sim::SpecimenStep& step, bool shear, double height_at_shear_m) {
  if (!shear) {
    now_.last.reset();
    now_.sum.reset();
    now_.pending = false;
    before_run_away_.reset();
    return;
  }
  if (step.state.run_away.count != before.run_away.count && !before_run_away_)
    before_run_away_ = now_;
  if (!now_.confirmed) add(time_s, dt_s, before, step, height_at_shear_m);
  if (!before_run_away_ || step.state.run_away.under_way) return;
  if (slipped(step.state)) {
    now_ = *before_run_away_;
    now_.sum.reset();
    now_.last.reset();
  }
  before_run_away_.reset();
}

void TruthWatch::add(double time_s, double dt_s, const sim::SpecimenState& before,
                     const sim::SpecimenStep& step, double height_at_shear_m) {
  if (now_.sum && now_.sum->path < kStill * lengths_.increment) {
    now_.sum.reset();
    now_.last.reset();
  }
  if (!now_.sum) now_.sum = Sum{.start_s = time_s, .before = before, .stress = {}, .strain = {}};
  now_.sum->dt_s += dt_s;
  now_.sum->stress.axial += step.stress_increment.axial;
  now_.sum->stress.radial += step.stress_increment.radial;
  now_.sum->strain.axial += step.strain_increment.axial;
  now_.sum->strain.radial += step.strain_increment.radial;
  const auto& d = step.strain_increment;
  now_.sum->path += std::sqrt(d.axial * d.axial + 2 * d.radial * d.radial);
  if (now_.sum->path < lengths_.increment) return;

  const auto de = now_.sum->strain;
  const double work = sim::second_order_work({}, now_.sum->stress, de).normalised;
  const Middle now{now_.sum->start_s + now_.sum->dt_s / 2, work, now_.sum->before, step.state,
                   now_.sum->dt_s};
  now_.sum.reset();
  if (work >= 0) {
    now_.pending = false;
  } else {
    if (!now_.pending) {
      now_.pending = true;
      now_.path = 0;
      open(now, height_at_shear_m);
    }
    now_.path += std::sqrt(de.axial * de.axial + 2 * de.radial * de.radial);
    now_.confirmed = now_.path >= lengths_.lasting;
  }
  now_.last = now;
}

}  // namespace triax::lab
