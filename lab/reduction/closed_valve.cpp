// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/closed_valve.hpp"

#include <fmt/format.h>

#include <cmath>

namespace triax::lab {

void ClosedValve::add(const Reading& reading, bool undrained_shear, double volume_m3) {
  if (!undrained_shear || !reading.has(Quantity::back_volume) || !(volume_m3 > 0)) return;
  const double volume = reading[Quantity::back_volume];
  if (stage_ != reading.stage) start_ = volume;
  stage_ = reading.stage;
  const double change = volume - start_;
  if (largest_ && std::fabs(change) <= std::fabs(largest_m3_)) return;
  largest_m3_ = change;
  largest_ = std::fabs(change) / volume_m3;
  reading_ = reading.number;
}

std::optional<Check> ClosedValve::check() const {
  if (!largest_) return std::nullopt;
  const bool ok = *largest_ <= kLimit;
  std::string note = "with the drainage closed the back volume did not change";
  if (!ok)
    note = fmt::format(
        "with the drainage closed {:.0f} mm3 flowed {} the specimen by reading {}: the valve does "
        "not close, or there is a leak; the test was not undrained",
        std::fabs(largest_m3_) * 1e9, largest_m3_ > 0 ? "to" : "from", reading_);
  return Check{.kind = CheckKind::undrained_volume,
               .measured = largest_,
               .limit = kLimit,
               .ok = ok,
               .note = std::move(note)};
}

}  // namespace triax::lab
