// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/results/reading.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// How the last consolidation stage ended.
///   consolidation    |dV_b/dt|/V over the last tenth of the stage (60 s or more), in % per hour
///   zero_difference  |u − u_b|/p′ over the last readings, at most a tenth of the stage: 0 once the
///                    water is at rest, unless one of the two sensors is off zero
class ConsolidationEnd {
 public:
  static constexpr double kRateLimit_pct_per_h = 0.1;
  static constexpr double kDifferenceLimit = 0.02;

  void add(const Reading& reading, const State& state, bool consolidation, double volume_m3);
  /// u − u_b at the end, Pa; empty if not both were read.
  std::optional<double> difference() const;
  std::vector<Check> checks() const;

 private:
  struct Point {
    double time_s = 0, volume = 0;
  };
  void keep(const Point& point);
  std::optional<double> rate_pct_per_h() const;

  std::optional<int> stage_;
  std::array<Point, 64> points_{};  ///< evenly thinned out as the stage grows
  std::size_t kept_ = 0;
  std::int64_t stride_ = 1, skipped_ = 0;
  Point last_;
  double volume_m3_ = 0;
  double difference_ = 0, p_eff_ = 0;  ///< fading means
  std::int64_t differences_ = 0;
  bool timed_ = true;
};

}  // namespace triax::lab
