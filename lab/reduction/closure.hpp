// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Columns that a file holds ready computed, held against our own reduction of the same readings.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/results/reading.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

class Closure {
 public:
  static constexpr double kLimit = 0.02;  ///< relative difference that passes

  void add(const Reading& reading, const State& state, bool in_shear);
  /// One check for each computed column of the file: measured is
  /// (ours − theirs)/ours, by least squares over the shear stage. `start_area` is our area at the
  /// start of shear; a volume counter that the record's reader had to join may explain a
  /// difference.
  std::vector<Check> checks(std::optional<double> start_area, bool back_volume_joined) const;

 private:
  struct Sums {
    double ours_theirs = 0, ours_ours = 0;
    std::int64_t count = 0;
  };
  std::string area_as_cause(double difference, double start_area, bool back_volume_joined) const;

  std::array<Sums, kQuantityCount> sums_{};
  double area_ratio_sum_ = 0;  ///< theirs/ours
  std::int64_t area_count_ = 0;
  std::optional<double> their_start_area_;
};

}  // namespace triax::lab
