#pragma once
// Columns that a file holds ready computed, held against our own reduction of the same readings.
#include <cstdint>
#include <optional>

#include "lab/collapse/test_summary.hpp"
#include "lab/records/reading.hpp"
#include "lab/reduction/state.hpp"

namespace triax::lab {

class Closure {
 public:
  static constexpr double kLimit = 0.02;  ///< relative difference of q that passes

  void add(const Reading& reading, const State& state, bool in_shear);
  /// The deviator stress's closure, if the file has one of its own: measured is (ours −
  /// theirs)/ours, by least squares over the shear stage. `start_area` is our area at the start of
  /// shear.
  std::optional<Check> check(std::optional<double> start_area,
                             const std::vector<Warning>& record_warnings) const;

 private:
  double ours_theirs_ = 0, ours_ours_ = 0;  ///< sums of products of q, Pa²
  double area_ratio_sum_ = 0;               ///< theirs/ours
  std::int64_t area_count_ = 0;
  std::optional<double> their_start_area_;
};

}  // namespace triax::lab
