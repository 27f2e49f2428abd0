// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>

#include "sim/specimen/specimen_state.hpp"

namespace triax::bench {

/// How near a simulated specimen itself came to an onset: the least normalised second-order work
/// of increments of kPath of strain during which η grew, in shear and inside the limit surface. No
/// instrument sees it.
class TrueWork {
 public:
  static constexpr double kPath = 1e-4;

  /// `limit`: η of the limit surface, above which nothing counts.
  explicit TrueWork(double limit) : limit_(limit) {}
  /// The specimen at the next reading.
  void add(const sim::SpecimenState& state, std::int64_t reading, bool in_shear);
  double least() const { return least_; }
  std::int64_t at_reading() const { return at_; }

 private:
  struct Point {
    double height_m, void_ratio, axial, radial;  ///< stresses Pa
    double eta;
  };
  double limit_;
  std::optional<Point> from_;
  double least_ = 1;
  std::int64_t at_ = 0;
};

}  // namespace triax::bench
