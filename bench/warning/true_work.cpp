// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/true_work.hpp"

#include <cmath>

#include "sim/mechanics/second_order_work.hpp"

namespace triax::bench {

void TrueWork::add(const sim::SpecimenState& state, std::int64_t reading, bool in_shear) {
  const double p = state.material.p(), q = state.material.q();
  const Point now{state.height_m, state.material.void_ratio, p + 2 * q / 3, p - q / 3,
                  std::fabs(q / p)};
  if (!in_shear) return from_.reset();
  if (!from_) {
    from_ = now;
    return;
  }
  const double axial = -std::log(now.height_m / from_->height_m);
  const double volume = -std::log((1 + now.void_ratio) / (1 + from_->void_ratio));
  const sim::AxisymmetricStrain strain{axial, (volume - axial) / 2};
  if (std::hypot(strain.axial, std::sqrt(2.0) * strain.radial) < kPath) return;
  const sim::AxisymmetricStress stress{now.axial - from_->axial, now.radial - from_->radial};
  const double work = sim::second_order_work({}, stress, strain).normalised;
  const bool counts = now.eta >= from_->eta && now.eta < limit_;
  from_ = now;
  if (!counts || work >= least_) return;
  least_ = work;
  at_ = reading;
}

}  // namespace triax::bench
