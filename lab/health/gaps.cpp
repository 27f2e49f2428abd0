// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/gaps.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace triax::lab {

void Gaps::end(std::int64_t first_reading) {
  gaps_.push_back({.first = first_reading});
  if (gaps_.size() > kKept) gaps_.pop_front();
}

void Gaps::add(const SecondOrderWorkPoint& point) {
  if (!(point.work.normalised > point.normalised_error)) return;
  const std::int64_t until = point.reading + point.window_readings / 2;
  for (Gap& gap : gaps_)
    if (point.reading >= gap.first) gap.sustained = std::min(gap.sustained.value_or(until), until);
}

std::optional<std::string> Gaps::caveat(const Collapse& collapse) const {
  if (!collapse.detected() || !collapse.onset) return std::nullopt;
  const std::int64_t onset = collapse.onset->reading;
  const auto leaves_open = [onset](const Gap& gap) {
    return gap.first <= onset && (!gap.sustained || onset <= *gap.sustained);
  };
  if (std::ranges::none_of(gaps_, leaves_open)) return std::nullopt;
  return fmt::format("at or before reading {}: readings are missing before it", onset);
}

}  // namespace triax::lab
