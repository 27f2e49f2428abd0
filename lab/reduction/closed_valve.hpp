// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>

#include "lab/health/sensor_limits.hpp"
#include "lab/results/reading.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// While the drainage is closed the back-pressure controller's volume stands still. Measured is its
/// largest departure within an undrained shear stage, |V_b − V_b,start|/V.
class ClosedValve {
 public:
  static constexpr double kLimit = sensor_limits::kClosedVolume;

  void add(const Reading& reading, bool undrained_shear, double volume_m3);
  /// Empty where no undrained shear with a back volume was seen.
  std::optional<Check> check() const;

 private:
  std::optional<int> stage_;
  double start_ = 0;
  std::optional<double> largest_;  ///< share of the volume
  double largest_m3_ = 0;
  std::int64_t reading_ = 0;
};

}  // namespace triax::lab
