// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/counter_join.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace triax::lab {

CounterJoin::CounterJoin() {
  // What is joined comes first: findings are told in this order.
  for (const auto zeroed : {RawChannel::Zeroed::joined, RawChannel::Zeroed::reported})
    for (const QuantityInfo& row : raw_channels())
      if (row.raw.zeroed == zeroed)
        counters_.push_back({.quantity = row.quantity,
                             .drift = row.raw.drift_si,
                             .joins = zeroed == RawChannel::Zeroed::joined});
}

void CounterJoin::apply(std::array<double, kQuantityCount>& si, int stage, bool stage_begins,
                        std::int64_t line, Findings& findings) {
  for (Counter& counter : counters_) {
    double& value = si[index(counter.quantity)];
    if (std::isnan(value)) continue;
    const double before = counter.last;
    counter.last = value;
    const bool reset = stage_begins && std::abs(before) > counter.drift &&
                       std::abs(value) <= std::abs(before) * (counter.joins ? 0.02 : 0.2);
    if (reset) {
      const QuantityInfo& row = info(counter.quantity);
      const auto unit = *sim::find_unit(row.unit);
      const auto jump =
          fmt::format("{} jumps from {:.6g} to {:.6g} {} at the start of stage {}", row.name,
                      before / unit.scale, value / unit.scale, row.unit, stage);
      if (counter.joins) {
        counter.offset += before - value;
        counter.joined = true;
        findings.note(fmt::format("reset {} {}", row.name, stage), line,
                      jump + ": the counter was set to zero; joined without a jump");
      } else {
        findings.note(fmt::format("reset {} {}", row.name, stage), line,
                      jump + ": unloaded, or the load cell was set to zero; not changed");
      }
    }
    if (counter.offset != 0) value += counter.offset;
  }
}

bool CounterJoin::joined(Quantity quantity) const {
  return std::ranges::any_of(counters_,
                             [&](const Counter& c) { return c.quantity == quantity && c.joined; });
}

}  // namespace triax::lab
