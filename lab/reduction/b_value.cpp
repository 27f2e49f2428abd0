// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/b_value.hpp"

#include <fmt/format.h>

#include <cmath>

namespace triax::lab {

void BValue::add(const Reading& reading, bool in_b_check) {
  if (!in_b_check || !reading.has(Quantity::cell_pressure) || !reading.has(Quantity::pore_pressure))
    return;
  const double cell = reading[Quantity::cell_pressure];
  const double pore = reading[Quantity::pore_pressure];
  if (stage_ != reading.stage) {
    stage_ = reading.stage;
    cell_start_ = cell;
    pore_start_ = pore;
  }
  constexpr double kLeastStep = 5e3;
  if (std::fabs(cell - cell_start_) >= kLeastStep)
    value_ = (pore - pore_start_) / (cell - cell_start_);
}

Check BValue::check() const {
  const bool ok = *value_ >= kLimit;
  return {.kind = CheckKind::b_value,
          .measured = value_,
          .limit = kLimit,
          .ok = ok,
          .note = ok ? "saturated"
                     : fmt::format("B {:.3f}: the specimen is not saturated or very stiff; pore "
                                   "pressures are smaller than in a saturated specimen",
                                   *value_)};
}

}  // namespace triax::lab
