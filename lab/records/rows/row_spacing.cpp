// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/row_spacing.hpp"

#include <cmath>

#include <fmt/format.h>

namespace triax::lab {

void RowSpacing::add(double value, std::int64_t line, bool restarts, Findings& findings) {
  if (std::isnan(value)) return;
  const double from = last_.value_or(value), step = value - from;
  const bool is_first = !last_ || restarts;
  last_ = value;
  if (is_first) {
    even_steps_ = 0;
    gap_.reset();
    return;
  }
  const double steps = even_steps_ > 0 ? step / step_ : 0;
  if (std::fabs(steps - 1) <= kEven_fraction) {
    // A mean over the latest rows follows a clock that is not quite even.
    step_ += (step - step_) / (even_steps_ < kRows_before ? ++even_steps_ : kRows_before);
    if (gap_ && ++gap_->even_steps_after == kRows_after) {
      report(*gap_, findings);
      gap_.reset();
    }
    return;
  }
  const bool skips = even_steps_ == kRows_before && !gap_ && steps >= 2 - kEven_fraction &&
                     std::fabs(steps - std::round(steps)) <= kEven_fraction * steps;
  if (skips) {
    gap_ = {.from = from, .to = value, .line = line};
    return;
  }
  gap_.reset();
  step_ = step;
  even_steps_ = 1;
}

void RowSpacing::report(const Gap& gap, Findings& findings) const {
  findings.note("rows missing", gap.line, [&] {
    const double missing = std::round((gap.to - gap.from) / step_) - 1;
    return fmt::format(
        "{:.0f} row{} missing before this line: {} goes from {:.6g} to {:.6g} in a series of equal "
        "steps of {:.4g}",
        missing, missing == 1 ? " is" : "s are", name_, gap.from, gap.to, step_);
  });
}

}  // namespace triax::lab
