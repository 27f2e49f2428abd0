// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "lab/results/second_order_work_point.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// Longer stretches of readings that could not be judged, and what they leave open: an onset that
/// is found after one may lie inside it or before, unless the second-order work was seen to be
/// positive in between. Remembers the last kKept stretches.
class Gaps {
 public:
  static constexpr std::size_t kKept = 64;

  /// Judgement goes on with this reading. Pre-condition: numbers ascend.
  void end(std::int64_t first_reading);
  /// A point of second-order work of what was judged; in any order.
  void add(const SecondOrderWorkPoint& point);
  /// "at or before reading 812: readings are missing before it", where that is all that is known.
  std::optional<std::string> caveat(const Collapse& collapse) const;

 private:
  struct Gap {
    std::int64_t first = 0;  ///< reading after it
    /// Reading up to which the first window since then reaches over which the work was positive.
    std::optional<std::int64_t> sustained{};
  };
  std::deque<Gap> gaps_;
};

}  // namespace triax::lab
